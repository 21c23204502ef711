// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace parhelion {

/// What crystals intercept, what goes straight on, and what was cut off; per surface.
struct SheetTotals {
  double intercepted = 0.0, undeviated = 0.0, cutOff = 0.0;

  void add(const SheetTotals& other, double factor) {
    intercepted += factor * other.intercepted;
    undeviated += factor * other.undeviated;
    cutOff += factor * other.cutOff;
  }
};

}  // namespace parhelion
