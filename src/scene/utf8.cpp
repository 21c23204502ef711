// SPDX-License-Identifier: Apache-2.0
#include "scene/utf8.h"

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

}  // namespace

std::string printable(std::string_view text, std::size_t maxLength) {
  std::string result;
  std::size_t count = 0;
  for (std::size_t at = 0; at < text.size(); ++count) {
    if (count == maxLength) return result + "…";
    const CodePoint c = decodeUtf8(text, at);
    if (c.value == '\t') {
      result += ' ';
    } else if (isControl(c.value) || !c.valid) {
      result += '?';
    } else {
      result += text.substr(at, c.length);
    }
    at += c.length;
  }
  return result;
}

std::string printableLines(std::string_view text) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const CodePoint c = decodeUtf8(text, at);
    const bool layout = c.value == '\t' || c.value == '\n' || text.substr(at).starts_with("\r\n");
    if (c.valid && (layout || !isControl(c.value))) {
      result += text.substr(at, c.length);
    } else {
      result += '?';
    }
    at += c.length;
  }
  return result;
}

std::string_view trimmed(std::string_view text) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  return text;
}

}  // namespace parhelion
