// SPDX-License-Identifier: Apache-2.0
#include "math/duration_text.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "math/number_text.h"

namespace parhelion {

namespace {

struct Unit {
  std::string_view name;
  double seconds;
};

constexpr double kDay = 24.0 * 3600.0;
constexpr std::array kUnits{Unit{"s", 1.0}, Unit{"min", 60.0}, Unit{"h", 3600.0}, Unit{"d", kDay}};

/// The digits at the front of a text, with a point among them.
std::string_view numberAtFront(std::string_view text) {
  return text.substr(0, std::min(text.find_first_not_of("0123456789."), text.size()));
}

std::string_view nameAtFront(std::string_view text) {
  return text.substr(0, std::min(text.find_first_of("0123456789."), text.size()));
}

}  // namespace

std::optional<double> secondsIn(std::string_view text) {
  if (const std::optional<double> plain = numberIn(text)) return plain;
  double sum = 0.0, last = kDay + 1.0;
  while (!text.empty()) {
    const std::string_view digits = numberAtFront(text);
    const std::string_view name = nameAtFront(text.substr(digits.size()));
    const std::optional<double> value = numberIn(digits);
    const auto* unit = std::find_if(kUnits.begin(), kUnits.end(), [&](const Unit& u) { return u.name == name; });
    // Units come from large to small, each once: 30min1h is more likely a slip.
    if (!value || unit == kUnits.end() || unit->seconds >= last) return {};
    sum += *value * unit->seconds;
    last = unit->seconds;
    text.remove_prefix(digits.size() + name.size());
  }
  return last <= kDay && std::isfinite(sum) ? std::optional(sum) : std::nullopt;
}

}  // namespace parhelion
