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

/// `text` for a terminal: control characters and broken bytes become '?', a tab one blank, so that columns stay; what
/// is longer than `maxLength` code points ends in "…".
std::string printable(std::string_view text, std::size_t maxLength);

/// A text of several lines for a terminal or a file: as printable(), but tabs and ends of lines, of either kind, stay.
std::string printableLines(std::string_view text);

/// `text` without the blanks at its ends.
std::string_view trimmed(std::string_view text);

}  // namespace parhelion
