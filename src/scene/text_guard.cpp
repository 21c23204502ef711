// SPDX-License-Identifier: Apache-2.0
#include "scene/text_guard.h"

#include <algorithm>
#include <utility>

#include "scene/utf8.h"

namespace parhelion {

namespace {

// A scene needs four: population, orientation, zenith, normal.
constexpr int kMaxNesting = 16;

/// Walks through a TOML text keeping line, column and whether it is inside a string or a comment.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {}

  std::optional<TextProblem> run() {
    while (at_ < text_.size() && !problem_) {
      const CodePoint c = decodeUtf8(text_, at_);
      if (!c.valid) {
        report("the text is not UTF-8 here", "save the file as UTF-8");
      } else if (inside_ == Inside::code) {
        scanCode(c);
      } else {
        scanQuoted(c);
      }
    }
    return problem_;
  }

 private:
  enum class Inside { code, comment, basic, literal, longBasic, longLiteral };

  void report(std::string message, std::string hint) {
    problem_ = TextProblem{line_, column_, std::move(message), std::move(hint)};
  }

  void advance(const CodePoint& c) {
    at_ += c.length;
    column_ = c.value == '\n' ? 1 : column_ + 1;
    if (c.value == '\n') ++line_;
  }

  void skipAscii(std::size_t count) {
    at_ += count;
    column_ += static_cast<int>(count);
  }

  std::size_t quotesHere(char quote) const {
    std::size_t count = 0;
    while (at_ + count < text_.size() && text_[at_ + count] == quote) ++count;
    return count;
  }

  void scanCode(const CodePoint& c) {
    if (c.value >= 0x80) {
      report("'" + std::string(text_.substr(at_, c.length)) + "' may stand only in strings and comments",
             "write keys in plain letters and put text in quotation marks");
      return;
    }
    countNesting(c.value);
    if (c.value == '"' || c.value == '\'') {
      openString(static_cast<char>(c.value));
    } else {
      if (c.value == '#') inside_ = Inside::comment;
      advance(c);
    }
  }

  void openString(char quote) {
    const bool isLong = quotesHere(quote) >= 3;
    if (quote == '"') {
      inside_ = isLong ? Inside::longBasic : Inside::basic;
    } else {
      inside_ = isLong ? Inside::longLiteral : Inside::literal;
    }
    skipAscii(isLong ? 3 : 1);
  }

  void scanQuoted(const CodePoint& c) {
    const bool isLong = inside_ == Inside::longBasic || inside_ == Inside::longLiteral;
    const bool escapes = inside_ == Inside::basic || inside_ == Inside::longBasic;
    const char quote = escapes ? '"' : '\'';
    if (c.value == '\n' && !isLong) {
      inside_ = Inside::code;  // the end of a comment, or of a string that the parser will complain about
    } else if (inside_ == Inside::comment) {
      // nothing but the end of the line matters
    } else if (escapes && c.value == '\\' && at_ + 1 < text_.size() &&
               (text_[at_ + 1] == '"' || text_[at_ + 1] == '\\')) {
      skipAscii(2);
      return;
    } else if (c.value == static_cast<char32_t>(quote) && (!isLong || quotesHere(quote) >= 3)) {
      // Up to two more quotation marks before the closing three belong to a long string.
      skipAscii(isLong ? std::min<std::size_t>(quotesHere(quote), 5) : 1);
      inside_ = Inside::code;
      return;
    }
    advance(c);
  }

  void countNesting(char32_t c) {
    if (c == '[' || c == '{') ++brackets_;
    if ((c == ']' || c == '}') && brackets_ > 0) --brackets_;
    if (c == '.') ++dots_;
    if (c == '\n' || c == '=' || c == ',' || c == '[' || c == '{') dots_ = 0;
    if (brackets_ > kMaxNesting || dots_ > kMaxNesting) {
      report("nested more than " + std::to_string(kMaxNesting) + " deep", "");
    }
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int line_ = 1;
  int column_ = 1;
  Inside inside_ = Inside::code;
  int brackets_ = 0;
  int dots_ = 0;  // of the dotted key at hand
  std::optional<TextProblem> problem_;
};

}  // namespace

std::optional<TextProblem> findTextProblem(std::string_view text) { return Scanner(text).run(); }

}  // namespace parhelion
