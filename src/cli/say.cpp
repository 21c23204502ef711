// SPDX-License-Identifier: Apache-2.0
#include "cli/say.h"

#include <cstdarg>
#include <cstdio>

#include "scene/utf8.h"

namespace parhelion::cli {

namespace {

// Bytes of a line. A path can have 4096, and what is wrong with it stands behind it.
constexpr std::size_t kMostBefore = 5000, kMostBehind = 1000;
constexpr std::size_t kMostOfWord = 100;  // characters
constexpr std::size_t kMostOfText = 500;  // bytes

std::string formatted(const char* format, std::va_list arguments) {
  std::va_list again;
  va_copy(again, arguments);
  const int length = std::vsnprintf(nullptr, 0, format, again);
  va_end(again);
  std::string text(static_cast<std::size_t>(length > 0 ? length : 0), '\0');
  std::vsnprintf(text.data(), text.size() + 1, format, arguments);
  return text;
}

void writeLine(std::FILE* stream, const std::string& line) {
  std::string shown = escaped(line);
  if (shown.size() > kMostBefore + kMostBehind) {
    const std::size_t begin = startOfCodePoint(shown, kMostBefore);
    shown.replace(begin, startOfCodePoint(shown, shown.size() - kMostBehind) - begin, "…");
  }
  shown += '\n';
  std::fputs(shown.c_str(), stream);
}

}  // namespace

void say(const char* format, ...) {
  std::va_list arguments;
  va_start(arguments, format);
  writeLine(stderr, formatted(format, arguments));
  va_end(arguments);
}

void answer(const char* format, ...) {
  std::va_list arguments;
  va_start(arguments, format);
  writeLine(stdout, formatted(format, arguments));
  va_end(arguments);
}

void sayLines(std::string_view text) { std::fputs(escapedLines(text).c_str(), stderr); }

void answerLines(std::string_view text) { std::fputs(escapedLines(text).c_str(), stdout); }

std::string shortened(std::string_view text) {
  if (text.size() <= kMostOfText) return std::string(text);
  return std::string(text.substr(0, startOfCodePoint(text, kMostOfText))) + "…";
}

std::string inQuotes(std::string_view word) { return "'" + printable(word, kMostOfWord) + "'"; }

}  // namespace parhelion::cli
