// SPDX-License-Identifier: Apache-2.0
#include "cli/duration.h"

#include <cmath>
#include <cstdio>

#include "cli/number_options.h"
#include "math/duration_text.h"
#include "math/range.h"

namespace parhelion::cli {

namespace {

constexpr double kMinute = 60.0;

}  // namespace

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
