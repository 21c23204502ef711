// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "scene/utf8.h"

using namespace parhelion;

TEST_CASE("lines for a terminal keep their layout, and what a terminal acts on is escaped") {
  for (const char* kept : {"", "a = 1\n\tb = '\u00B0'\n", "a = 1\r\nb = 2\r\n", "no end", "\xEF\xBB\xBF# mark"})
    CHECK_MESSAGE(escapedLines(kept) == kept, kept);
  CHECK(escapedLines("\x1b[31mred\a") == "\\u001b[31mred\\u0007");
  CHECK(escapedLines("over\rwritten\r") == "over\\u000dwritten\\u000d");
  CHECK(escapedLines("\xC2\x9B"
                     "31m \xFF") == "\\u009b31m \\xff");
}

TEST_CASE("a word for a terminal stays on its line and shows what turns letters round") {
  CHECK(escaped("a\nb") == "a\\u000ab");
  CHECK(escaped("\u202Egnp.exr") == "\\u202egnp.exr");
  CHECK(escaped("\u2066\u200F\u061C\u2028\uFEFF") == "\\u2066\\u200f\\u061c\\u2028\\ufeff");
  CHECK(escaped("\U000E0041") == "\\U000e0041");
  CHECK(escaped("\xE2\x80") == "\\xe2\\x80");
  // Letters of all scripts, and what joins them, stay.
  for (const char* kept : {"caf\u00E9", "\u05D0\u05D1", "\u0646\u200C\u0645", "\U0001F31E\uFE0F", "22\u00B0"})
    CHECK_MESSAGE(escaped(kept) == kept, kept);
  CHECK(printable("\x1b\u202E\xFF\t|", 10) == "??? |");
}

TEST_CASE("texts are cut between code points") {
  CHECK(startOfCodePoint("a\u00B0b", 2) == 1);
  CHECK(startOfCodePoint("a\u00B0b", 3) == 3);
  CHECK(startOfCodePoint("\x80\x80", 1) == 0);
}
