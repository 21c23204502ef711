// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <nlohmann/json.hpp>
#include <string>

namespace parhelion {

using Json = nlohmann::ordered_json;

/// The numbers that a key accepts. NaN and infinities are in no range.
struct Range {
  double lo = 0.0;
  double hi = std::numeric_limits<double>::max();
  bool loOpen = false;  // `lo` itself is out
  bool hiOpen = false;

  bool contains(double value) const {
    return (loOpen ? value > lo : value >= lo) && (hiOpen ? value < hi : value <= hi);
  }

  std::string text() const;   // "from -90 to 90", "above 0 and below 90"
  Json numberSchema() const;  // draft-04: {"type": "number", "minimum": …}
};

/// The shortest decimal of at most twelve digits, which hides the rounding of a conversion to radians and back.
std::string formatNumber(double value);

/// The same as a number, for JSON.
double roundToTwelveDigits(double value);

}  // namespace parhelion
