// SPDX-License-Identifier: Apache-2.0
#include "cli/number_options.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

#include "cli/say.h"
#include "math/number_text.h"
#include "math/range.h"

namespace parhelion::cli {

namespace {

constexpr double kLargest = 1e6;  // pixels from the picture's corner to a place, also outside it; others are smaller

/// Of a number within bounds, by the function that reads it.
template <class Number>
CLI::Validator bounded(std::optional<Number> (*read)(std::string_view), Number least, Number most,
                       std::string expected) {
  return CLI::Validator(
      [=](std::string& text) -> std::string {
        const std::optional<Number> value = read(text);
        if (!value || *value < least || *value > most) return expectedNot(expected, text);
        char digits[32];
        text.assign(digits, std::to_chars(digits, digits + sizeof digits, *value).ptr);
        return {};
      },
      "");
}

}  // namespace

CLI::Validator number(double least, double most) {
  return bounded(&numberIn, least, most, "a number from " + formatNumber(least) + " to " + formatNumber(most));
}

CLI::Validator wholeNumber(std::int64_t least, std::int64_t most) {
  return bounded(&wholeNumberIn, least, most,
                 "a whole number from " + std::to_string(least) + " to " + std::to_string(most));
}

CLI::Validator wholeNumber() { return wholeNumber(0, std::numeric_limits<std::int64_t>::max()); }

std::string expectedNot(const std::string& expected, std::string_view word) {
  return "expected " + expected + ", not " + inQuotes(word);
}

std::vector<double> numbersIn(std::string_view text, std::string_view separators) {
  std::vector<double> all;
  for (std::size_t i = 0; i <= separators.size(); ++i) {
    const bool last = i == separators.size();
    const std::size_t end = last ? text.size() : text.find(separators[i]);
    const std::optional<double> value = numberIn(text.substr(0, end));
    if (end == std::string_view::npos || !value || std::abs(*value) > kLargest) return {};
    all.push_back(*value);
    text.remove_prefix(last ? end : end + 1);
  }
  return all;
}

std::vector<double> commaSeparated(std::string_view text) {
  return numbersIn(text, std::string(static_cast<std::size_t>(std::ranges::count(text, ',')), ','));
}

}  // namespace parhelion::cli
