// SPDX-License-Identifier: Apache-2.0
#include "scene/text_guard.h"

#include <utility>

#include "picture/limits.h"
#include "scene/utf8.h"

namespace parhelion {

namespace {

bool isBlank(char32_t c) { return c == ' ' || c == '\t'; }

bool startsKey(char c) {
  const bool isLetter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
  return isLetter || (c >= '0' && c <= '9') || c == '-' || c == '_' || c == '"' || c == '\'';
}

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

  /// Quotation marks from here on; five, which end a long string, are as many as matter.
  std::size_t quotesHere(char quote) const {
    std::size_t count = 0;
    while (count < 5 && at_ + count < text_.size() && text_[at_ + count] == quote) ++count;
    return count;
  }

  void scanCode(const CodePoint& c) {
    if (c.value >= 0x80) {
      report(std::string("'").append(text_.substr(at_, c.length)) + "' may stand only in strings and comments",
             "write keys in plain letters and put text in quotation marks");
      return;
    }
    if (c.value == '[' && startsLine_ && open_.empty()) checkHeader();
    checkNumber(static_cast<char>(c.value));
    if (problem_) return;
    countNesting(c.value);
    startsLine_ = c.value == '\n' || (startsLine_ && isBlank(c.value));
    if (c.value == '"' || c.value == '\'') {
      openString(static_cast<char>(c.value));
    } else {
      if (c.value == '#') inside_ = Inside::comment;
      advance(c);
    }
  }

  /// A table's header, "[name]" or "[[name]]": toml++ 3.3.0 takes for granted that a name follows the bracket.
  void checkHeader() {
    std::size_t name = at_ + 1;
    if (name < text_.size() && text_[name] == '[') ++name;
    while (name < text_.size() && isBlank(static_cast<unsigned char>(text_[name]))) ++name;
    if (name < text_.size() && startsKey(text_[name])) return;
    skipAscii(name - at_);
    report("the name of a table is missing here", "");
  }

  /// toml++ 3.3.0 reads on after a number up to the next blank or so, also into what is a string to everybody else.
  void checkNumber(char c) {
    if (inNumber_ && std::string_view("\"'[{=").find(c) != std::string_view::npos) {
      report(std::string("a number cannot be followed by '") + c + "'", "");
    }
    if (startsWord_) inNumber_ = (c >= '0' && c <= '9') || c == '+' || c == '-' || c == '.';
    startsWord_ = std::string_view(" \t\r\n]},#=[{").find(c) != std::string_view::npos;
    inNumber_ = inNumber_ && !startsWord_;
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
      startsLine_ = startsWord_ = true;
      inside_ = Inside::code;  // the end of a comment, or of a string that the parser will complain about
    } else if (inside_ == Inside::comment) {
      // nothing but the end of the line matters
    } else if (escapes && c.value == '\\' && at_ + 1 < text_.size() &&
               (text_[at_ + 1] == '"' || text_[at_ + 1] == '\\')) {
      skipAscii(2);
      return;
    } else if (c.value == static_cast<char32_t>(quote) && (!isLong || quotesHere(quote) >= 3)) {
      // Up to two more quotation marks before the closing three belong to a long string.
      skipAscii(isLong ? quotesHere(quote) : 1);
      inside_ = Inside::code;
      return;
    }
    advance(c);
  }

  void countNesting(char32_t c) {
    if (c == '[' || c == '{') open_ += static_cast<char>(c);
    if (c == ']' || c == '}') closeBracket(static_cast<char>(c));
    if (c == '.') ++dots_;
    if (c == '\n' || c == '=' || c == ',' || c == '[' || c == '{') dots_ = 0;
    if (open_.size() > kMostNesting || dots_ > kMostNesting) {
      report(std::string("nested more than ").append(std::to_string(kMostNesting)) + " deep", "");
    }
  }

  /// Complains where the bracket closes one of the other kind, on which toml++ 3.3.0 does not count.
  void closeBracket(char c) {
    if (open_.empty()) return;  // the parser's to refuse
    if ((open_.back() == '[') != (c == ']')) {
      report(std::string("'") + c + "' cannot close the '" + open_.back() + "' before it", "");
    }
    open_.pop_back();
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int line_ = 1;
  int column_ = 1;
  Inside inside_ = Inside::code;
  bool startsLine_ = true;  // nothing but blanks since the line began
  bool startsWord_ = true;  // here a key or a value may begin
  bool inNumber_ = false;   // in a word that begins like a number
  std::string open_;        // the brackets that are not closed yet
  std::size_t dots_ = 0;    // of the dotted key at hand
  std::optional<TextProblem> problem_;
};

}  // namespace

std::optional<TextProblem> findTextProblem(std::string_view text) { return Scanner(text).run(); }

}  // namespace parhelion
