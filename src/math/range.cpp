// SPDX-License-Identifier: Apache-2.0
#include "math/range.h"

#include <charconv>

namespace parhelion {

std::string Range::text() const {
  const std::string low =
      loOpen ? std::string("above ").append(formatNumber(lo)) : std::string("at least ").append(formatNumber(lo));
  if (hi == std::numeric_limits<double>::max()) return low;
  if (!loOpen && !hiOpen) return std::string("from ").append(formatNumber(lo)) + " to " + formatNumber(hi);
  return low + " and " + (hiOpen ? "below " : "at most ") + formatNumber(hi);
}

std::string formatNumber(double value) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::general, 12).ptr;
  return {text, end};
}

double roundToTwelveDigits(double value) {
  const std::string text = formatNumber(value);
  double rounded = 0.0;
  std::from_chars(text.data(), text.data() + text.size(), rounded);
  return rounded;
}

}  // namespace parhelion
