// SPDX-License-Identifier: Apache-2.0
#include "math/duration_text.h"

#include <doctest/doctest.h>

using namespace parhelion;

TEST_CASE("times are numbers with units, from large to small, and a number alone is seconds") {
  CHECK(secondsIn("0.5s") == 0.5);
  CHECK(secondsIn("90") == 90.0);
  CHECK(secondsIn("10min") == 600.0);
  CHECK(secondsIn("2h") == 7200.0);
  CHECK(secondsIn("1.5d") == 129600.0);
  CHECK(secondsIn("1h30min") == 5400.0);
  for (const char* text : {"", "s", "min", "10m", "10 min", "1e400s", "nan", "inf", "1h1h", "30min1h", "1h30", "--5",
                           "0x10", "10minutes", "1,5h", "h1"})
    CHECK_MESSAGE(!secondsIn(text), text);
}
