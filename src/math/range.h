// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <string>

namespace parhelion {

/// The numbers that something accepts. NaN and infinities are in no range.
struct Range {
  double lo = 0.0;
  double hi = std::numeric_limits<double>::max();
  bool loOpen = false;  // `lo` itself is out
  bool hiOpen = false;

  constexpr bool contains(double value) const {
    return (loOpen ? value > lo : value >= lo) && (hiOpen ? value < hi : value <= hi);
  }

  std::string text() const;  // "from -90 to 90", "above 0 and below 90"
};

/// The shortest decimal of at most twelve digits, which hides the rounding of a conversion to radians and back.
std::string formatNumber(double value);

/// The same as a number.
double roundToTwelveDigits(double value);

}  // namespace parhelion
