// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "math/exact_sum.h"

namespace parhelion {

/// Where the light of a run went, in units of one ray's light. in = out + filtered + absorbed + cutOff + lost, to
/// rounding. Light is `filtered` that left its crystal by a path that the run does not keep.
struct EnergyLedger {
  ExactSum in, out, filtered, absorbed, cutOff, lost;

  void merge(const EnergyLedger& other);

  /// in less all the rest, as a share of in.
  double imbalance() const;
};

}  // namespace parhelion
