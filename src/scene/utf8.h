// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace parhelion {

struct CodePoint {
  char32_t value;      // U+FFFD where the bytes are not UTF-8
  std::size_t length;  // bytes; 1 where they are not UTF-8
  bool valid;
};

/// The code point that starts at byte `at` of `text`. Overlong forms, surrogates and cut-off sequences are not valid.
CodePoint decodeUtf8(std::string_view text, std::size_t at);

std::size_t countCodePoints(std::string_view text);

/// `text` for a terminal, on one line: what would act on the terminal, or hide or turn round what stands beside it, is
/// written as TOML does in strings, an escape as \u001b and a line's end as \u000a; bytes that are not UTF-8 as \xff.
std::string escaped(std::string_view text);

/// The same of a text of several lines: the ends of lines, of either kind, stay.
std::string escapedLines(std::string_view text);

/// `text` on one line where columns count: each such character becomes one '?', a tab one blank; what is longer than
/// `maxLength` code points ends in "…".
std::string printable(std::string_view text, std::size_t maxLength);

/// The byte where the code point of a UTF-8 text begins that byte `at` belongs to.
std::size_t startOfCodePoint(std::string_view text, std::size_t at);

/// `text` without the characters at its ends that are among `blanks`.
std::string_view trimmed(std::string_view text, std::string_view blanks = " ");

}  // namespace parhelion
