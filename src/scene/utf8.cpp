// SPDX-License-Identifier: Apache-2.0
#include "scene/utf8.h"

#include <algorithm>
#include <cstdio>

namespace parhelion {

CodePoint decodeUtf8(std::string_view text, std::size_t at) {
  constexpr CodePoint kBroken{0xFFFD, 1, false};
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned lead = byte(at);
  if (lead < 0x80) return {lead, 1, true};

  const std::size_t length = lead < 0xC0 ? 0 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : lead < 0xF8 ? 4 : 0;
  if (length == 0 || at + length > text.size()) return kBroken;
  char32_t value = lead & (0x7Fu >> length);
  for (std::size_t i = at + 1; i < at + length; ++i) {
    if ((byte(i) & 0xC0u) != 0x80u) return kBroken;
    value = (value << 6) | (byte(i) & 0x3Fu);
  }

  constexpr char32_t kSmallest[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = value >= 0xD800 && value <= 0xDFFF;
  if (value < kSmallest[length] || value > 0x10FFFF || surrogate) return kBroken;
  return {value, length, true};
}

std::size_t countCodePoints(std::string_view text) {
  std::size_t count = 0;
  for (std::size_t at = 0; at < text.size(); at += decodeUtf8(text, at).length) ++count;
  return count;
}

namespace {

bool isControl(char32_t c) { return c < 0x20 || (c >= 0x7F && c < 0xA0); }

/// Characters that nobody sees and that change how others are shown: marks of the direction of writing (Unicode
/// Standard Annex 9, 2.3 to 2.6), ends of lines and paragraphs, blanks of no width, and tags.
bool isInvisible(char32_t c) {
  return c == 0x061C || c == 0x200B || c == 0x200E || c == 0x200F || (c >= 0x2028 && c <= 0x202E) ||
         (c >= 0x2060 && c <= 0x206F) || c == 0xFEFF || (c >= 0xFFF9 && c <= 0xFFFB) || (c >= 0xE0000 && c <= 0xE0FFF);
}

bool isPlain(const CodePoint& c) { return c.valid && !isControl(c.value) && !isInvisible(c.value); }

/// As TOML writes it in a string, \u001b; a byte that belongs to no character as \xff.
std::string escapeOf(const CodePoint& c, char byte) {
  char text[12];
  if (!c.valid)
    std::snprintf(text, sizeof text, "\\x%02x", static_cast<unsigned>(static_cast<unsigned char>(byte)));
  else
    std::snprintf(text, sizeof text, c.value > 0xFFFF ? "\\U%08x" : "\\u%04x", static_cast<unsigned>(c.value));
  return text;
}

std::string escapedBut(std::string_view text, bool keepsLines) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const CodePoint c = decodeUtf8(text, at);
    const bool mark = at == 0 && c.value == 0xFEFF;  // of the byte order, with which a file may begin
    const bool layout = keepsLines && (mark || c.value == '\n' || text.substr(at).starts_with("\r\n"));
    if (isPlain(c) || layout || c.value == '\t')
      result += text.substr(at, c.length);
    else
      result += escapeOf(c, text[at]);
    at += c.length;
  }
  return result;
}

}  // namespace

std::string escaped(std::string_view text) { return escapedBut(text, false); }

std::string escapedLines(std::string_view text) { return escapedBut(text, true); }

std::string printable(std::string_view text, std::size_t maxLength) {
  std::string result;
  std::size_t count = 0;
  for (std::size_t at = 0; at < text.size(); ++count) {
    if (count == maxLength) return result + "…";
    const CodePoint c = decodeUtf8(text, at);
    if (c.value == '\t') {
      result += ' ';
    } else if (isPlain(c)) {
      result += text.substr(at, c.length);
    } else {
      result += '?';
    }
    at += c.length;
  }
  return result;
}

std::size_t startOfCodePoint(std::string_view text, std::size_t at) {
  while (at > 0 && at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0u) == 0x80u) --at;
  return at;
}

std::string_view trimmed(std::string_view text, std::string_view blanks) {
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  return text.substr(0, text.find_last_not_of(blanks) + 1);
}

}  // namespace parhelion
