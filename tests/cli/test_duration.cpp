// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <limits>

#include "cli/duration.h"

using namespace parhelion::cli;

TEST_CASE("times are told in the units that people use for them") {
  CHECK(durationText(0.001) == "0.001 s");
  CHECK(durationText(42.3) == "42 s");
  CHECK(durationText(600.0) == "10 min");
  CHECK(durationText(7200.0) == "2 h");
  CHECK(durationText(12'000.0) == "3 h 20 min");
  CHECK(durationText(2 * 86'400.0 + 5 * 3600.0) == "2 d 5 h");
  for (const double endless : {1e15, 1e98, std::numeric_limits<double>::infinity()})
    CHECK(durationText(endless) == "forever");
}
