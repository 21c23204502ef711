// SPDX-License-Identifier: Apache-2.0
#include "math/date_time.h"

#include <doctest/doctest.h>

using namespace parhelion;

TEST_CASE("seconds from 1970 count days of the Gregorian calendar, by UTC") {
  CHECK(unixSeconds({1970, 1, 1, 0, 0, 0.0, 0}) == 0.0);
  CHECK(unixSeconds({2000, 3, 1, 0, 0, 0.0, 0}) == 951868800.0);
  CHECK(unixSeconds({2026, 12, 21, 9, 30, 0.5, 60}) == unixSeconds({2026, 12, 21, 8, 30, 0.5, 0}));
  CHECK(unixSeconds({1969, 12, 31, 23, 59, 59.0, 0}) == -1.0);
}

TEST_CASE("a moment reads on every clock, and its text reads back") {
  const double moment = unixSeconds({2026, 12, 31, 23, 50, 0.0, 60}) + 600.25;
  CHECK(textOf(dateTimeAt(moment, 60)) == "2027-01-01T00:00:00.25+01:00");
  CHECK(textOf(dateTimeAt(moment, 0)) == "2026-12-31T23:00:00.25Z");
  CHECK(textOf(dateTimeAt(moment, -570)) == "2026-12-31T13:30:00.25-09:30");
  for (const int offset : {-720, -90, 0, 60, 345}) {
    const DateTime time = dateTimeAt(moment, offset);
    const auto again = dateTimeAtFront(textOf(time));
    REQUIRE(again);
    CHECK(again->time == time);
    CHECK(again->length == textOf(time).size());
  }
  // Rounded to a microsecond, never to a sixtieth second.
  CHECK(textOf(dateTimeAt(unixSeconds({2026, 1, 1, 11, 59, 59.9999999, 0}), 0)) == "2026-01-01T12:00:00Z");
}

TEST_CASE("a date at the front of a text may lack its seconds, and what follows it is left") {
  const auto found = dateTimeAtFront("2026-12-21T09:30+01:00:10min");
  REQUIRE(found);
  CHECK(found->time == DateTime{2026, 12, 21, 9, 30, 0.0, 60});
  CHECK(found->length == 22);
  CHECK(dateTimeAtFront("2026-12-21 09:30:15.5z")->time == DateTime{2026, 12, 21, 9, 30, 15.5, 0});
}

TEST_CASE("dates that do not exist, and those without an offset, are none") {
  for (const char* text :
       {"2026-02-29T09:30:00Z", "2026-02-30T09:30:00Z", "2026-13-01T09:30:00Z", "2026-00-01T09:30:00Z",
        "2026-04-31T09:30:00Z", "2026-12-21T24:00:00Z", "2026-12-21T09:60:00Z", "2026-12-21T09:30:60Z",
        "2026-12-21T09:30:00", "2026-12-21", "2026-12-21T09:30:00.Z", "2026-12-21T09:30:00+24:00", "26-12-21T09:30:00Z",
        "", "-", "2026-12-21T9:30:00Z"})
    CHECK_MESSAGE(!dateTimeAtFront(text), text);
  CHECK(dateTimeAtFront("2024-02-29T09:30:00Z"));
  CHECK(beginsAsDate("2026-99"));
  CHECK_FALSE(beginsAsDate("20:26:1"));
  CHECK_FALSE(beginsAsDate("2026"));
}
