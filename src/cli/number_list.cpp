// SPDX-License-Identifier: Apache-2.0
#include "cli/number_list.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

namespace parhelion::cli {

namespace {

constexpr double kLargest = 1e6;  // pixels from the picture's corner to a place, also outside it; others are smaller

}  // namespace

std::vector<double> numbersIn(std::string_view text, std::string_view separators) {
  std::vector<double> all;
  for (std::size_t i = 0;; ++i) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || !std::isfinite(value) || std::abs(value) > kLargest) return {};
    all.push_back(value);
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    if (text.empty()) return i == separators.size() ? all : std::vector<double>{};
    if (i == separators.size() || text.front() != separators[i]) return {};
    text.remove_prefix(1);
  }
}

std::vector<double> commaSeparated(std::string_view text) {
  return numbersIn(text, std::string(static_cast<std::size_t>(std::ranges::count(text, ',')), ','));
}

}  // namespace parhelion::cli
