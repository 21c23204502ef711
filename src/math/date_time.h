// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace parhelion {

/// A date of the Gregorian calendar with a time of the day, and how far that clock is from UTC.
struct DateTime {
  int year = 2000;
  int month = 1;  // [1, 12]
  int day = 1;    // [1, 31], as many as the month has
  int hour = 0;
  int minute = 0;
  double second = 0.0;  // [0, 60)
  int offset = 0;       // minutes by which the clock is ahead of UTC

  bool operator==(const DateTime&) const = default;
};

/// Seconds of UTC from 1970-01-01T00:00:00Z, leap seconds not counted.
double unixSeconds(const DateTime& time);

/// The date and time on a clock `offset` minutes ahead of UTC, rounded to a microsecond.
DateTime dateTimeAt(double unixSeconds, int offset);

/// As RFC 3339 and TOML write it: "2026-12-21T09:30:00+01:00", with decimals of the second where there are some.
std::string textOf(const DateTime& time);

/// Whether the text begins as a date does, though there may be none of that kind: with four digits and a hyphen.
bool beginsAsDate(std::string_view text);

struct DateTimeAtFront {
  DateTime time;
  std::size_t length = 0;  // of its text
};

/// The date, time and offset at the front of a text, as textOf() writes them; a blank or t for the T, and no seconds,
/// will do. None for anything else, such as a date that does not exist.
std::optional<DateTimeAtFront> dateTimeAtFront(std::string_view text);

}  // namespace parhelion
