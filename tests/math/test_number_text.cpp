// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "math/number_text.h"

using namespace parhelion;

TEST_CASE("a number is decimal digits with a sign, a point and an exponent, and nothing behind") {
  CHECK(numberIn("1") == 1.0);
  CHECK(numberIn("+1.5") == 1.5);
  CHECK(numberIn("-2e3") == -2000.0);
  CHECK(numberIn(".5") == 0.5);
  CHECK(numberIn("007") == 7.0);
  for (const char* bad : {"", " ", "+", "-", ".", "e5", "1e", "+-1", "-+1", "++1", "--1", "nan", "-nan", "inf", "+inf",
                          "infinity", "1e999", "0x10", "0x1p3", "1,5", "1_0", "1 ", " 1", "1a", "1.2.3", "\xD9\xA3"})
    CHECK_MESSAGE(!numberIn(bad), bad);
}

TEST_CASE("a whole number is decimal whatever zeros stand before it") {
  CHECK(wholeNumberIn("010") == 10);
  CHECK(wholeNumberIn("+8") == 8);
  CHECK(wholeNumberIn("-8") == -8);
  CHECK(wholeNumberIn("9223372036854775807") == INT64_MAX);
  for (const char* bad : {"", "+", "+-1", "1.0", "1e3", "0x10", "9223372036854775808", "1k", " 1"})
    CHECK_MESSAGE(!wholeNumberIn(bad), bad);
}
