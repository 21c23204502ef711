// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "scene/utf8.h"

using namespace parhelion;

TEST_CASE("lines for a terminal keep their layout and lose what a terminal acts on") {
  for (const char* kept : {"", "a = 1\n\tb = '\u00B0'\n", "a = 1\r\nb = 2\r\n", "no end", "\xEF\xBB\xBF# mark"})
    CHECK_MESSAGE(printableLines(kept) == kept, kept);
  CHECK(printableLines("\x1b[31mred\a") == "?[31mred?");
  CHECK(printableLines("over\rwritten\r") == "over?written?");
  CHECK(printableLines("\xC2\x9B"
                       "31m \xFF") == "?31m ?");
}
