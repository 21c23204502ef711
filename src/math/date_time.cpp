// SPDX-License-Identifier: Apache-2.0
#include "math/date_time.h"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace parhelion {

namespace {

constexpr double kSecondsOfDay = 86400.0;
constexpr double kMicroseconds = 1e6;  // in a second

std::chrono::year_month_day dateOf(const DateTime& time) {
  return {std::chrono::year(time.year), std::chrono::month(static_cast<unsigned>(time.month)),
          std::chrono::day(static_cast<unsigned>(time.day))};
}

/// Takes a text apart from the front; after the first thing that is missing, nothing is found any more.
class FrontReader {
 public:
  explicit FrontReader(std::string_view text) : text_(text) {}

  bool good() const { return good_; }
  std::size_t at() const { return at_; }

  bool nextIs(std::string_view characters) const {
    return good_ && at_ < text_.size() && characters.find(text_[at_]) != std::string_view::npos;
  }
  char take(std::string_view characters) {
    good_ = nextIs(characters);
    return good_ ? text_[at_++] : '\0';
  }
  /// A number of exactly so many digits, at most `most`.
  int number(int digits, int most) {
    int value = 0;
    for (int i = 0; i < digits && good_; ++i) value = 10 * value + (take("0123456789") - '0');
    good_ = good_ && value <= most;
    return value;
  }
  /// ".25"
  double decimals() {
    double value = 0.0, place = 1.0;
    take(".");
    do {
      place /= 10.0;
      value += place * (take("0123456789") - '0');
    } while (nextIs("0123456789"));
    return value;
  }

 private:
  std::string_view text_;
  std::size_t at_ = 0;
  bool good_ = true;
};

}  // namespace

double unixSeconds(const DateTime& time) {
  const auto days = std::chrono::sys_days(dateOf(time)).time_since_epoch().count();
  return static_cast<double>(days) * kSecondsOfDay + 3600.0 * time.hour + 60.0 * (time.minute - time.offset) +
         time.second;
}

DateTime dateTimeAt(double unixSeconds, int offset) {
  const double clock = std::round((unixSeconds + 60.0 * offset) * kMicroseconds) / kMicroseconds;
  const double day = std::floor(clock / kSecondsOfDay);
  const std::chrono::year_month_day date(std::chrono::sys_days(std::chrono::days(static_cast<int>(day))));
  const double ofDay = clock - day * kSecondsOfDay;
  const int minutes = static_cast<int>(ofDay / 60.0);
  return {static_cast<int>(date.year()),
          static_cast<int>(static_cast<unsigned>(date.month())),
          static_cast<int>(static_cast<unsigned>(date.day())),
          minutes / 60,
          minutes % 60,
          std::round((ofDay - 60.0 * minutes) * kMicroseconds) / kMicroseconds,
          offset};
}

std::string textOf(const DateTime& time) {
  char text[64];
  std::snprintf(text, sizeof text, "%04d-%02d-%02dT%02d:%02d:%09.6f", time.year, time.month, time.day, time.hour,
                time.minute, time.second);
  std::string whole = text;
  whole.erase(whole.find_last_not_of('0') + 1);
  if (whole.ends_with('.')) whole.pop_back();
  if (time.offset == 0) return whole + 'Z';
  const int size = std::abs(time.offset);
  std::snprintf(text, sizeof text, "%c%02d:%02d", time.offset < 0 ? '-' : '+', size / 60, size % 60);
  return whole + text;
}

bool beginsAsDate(std::string_view text) {
  FrontReader reader(text);
  reader.number(4, 9999);
  reader.take("-");
  return reader.good();
}

std::optional<DateTimeAtFront> dateTimeAtFront(std::string_view text) {
  FrontReader reader(text);
  DateTime time;
  time.year = reader.number(4, 9999);
  reader.take("-");
  time.month = reader.number(2, 12);
  reader.take("-");
  time.day = reader.number(2, 31);
  reader.take("Tt ");
  time.hour = reader.number(2, 23);
  reader.take(":");
  time.minute = reader.number(2, 59);
  if (reader.nextIs(":")) {
    reader.take(":");
    time.second = reader.number(2, 59);
    if (reader.nextIs(".")) time.second += reader.decimals();
  }
  const char sign = reader.take("Zz+-");
  if (sign == '+' || sign == '-') {
    const int hours = reader.number(2, 23);
    reader.take(":");
    time.offset = (sign == '-' ? -1 : 1) * (60 * hours + reader.number(2, 59));
  }
  if (!reader.good() || !dateOf(time).ok()) return std::nullopt;
  return DateTimeAtFront{time, reader.at()};
}

}  // namespace parhelion
