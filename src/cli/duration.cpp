// SPDX-License-Identifier: Apache-2.0
#include "cli/duration.h"

#include <array>
#include <cmath>
#include <cstdio>

#include "cli/number_options.h"
#include "math/number_text.h"
#include "math/range.h"

namespace parhelion::cli {

namespace {

struct Unit {
  std::string_view name;
  double seconds;
};

constexpr double kMinute = 60.0, kHour = 60.0 * kMinute, kDay = 24.0 * kHour;
constexpr std::array kUnits{Unit{"s", 1.0}, Unit{"min", kMinute}, Unit{"h", kHour}, Unit{"d", kDay}};

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

CLI::Validator duration(double least, double most, std::string also) {
  return CLI::Validator(
      [=](const std::string& text) -> std::string {
        if (!also.empty() && text == also) return {};
        const std::optional<double> seconds = secondsIn(text);
        if (seconds && *seconds >= least && *seconds <= most) return {};
        return expectedNot("a time from " + durationText(least) + " to " + durationText(most) +
                               " such as 90s, 10min, 2h or 1d" + (also.empty() ? "" : ", or " + also),
                           text);
      },
      "");
}

CLI::Validator durationInSeconds(double least, double most) {
  const CLI::Validator check = duration(least, most);
  return CLI::Validator(
      [=](std::string& text) {
        std::string complaint = check(text);
        if (complaint.empty()) text = formatNumber(*secondsIn(text));
        return complaint;
      },
      "");
}

std::string durationText(double seconds) {
  constexpr double kForever =
      1e15;  // s, 30 million years; minutes of more than some thousand times that fit no integer
  if (!(seconds < kForever)) return "forever";
  char text[64];
  const auto write = [&](const char* format, auto... values) {
    std::snprintf(text, sizeof text, format, values...);
    return std::string(text);
  };
  if (seconds < 99.5) return write("%.3g s", seconds < 10.0 ? seconds : std::round(seconds));
  const auto minutes = static_cast<long long>(std::round(seconds / kMinute));
  if (minutes < 100) return write("%lld min", minutes);
  const long long hours = minutes / 60, rest = minutes % 60;
  if (hours < 48) return rest == 0 ? write("%lld h", hours) : write("%lld h %lld min", hours, rest);
  return hours % 24 == 0 ? write("%lld d", hours / 24) : write("%lld d %lld h", hours / 24, hours % 24);
}

}  // namespace parhelion::cli
