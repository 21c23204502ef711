// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <random>

#include "scene_support.h"

using namespace parhelion;
using namespace parhelion::test;

namespace {

/// Parses, or throws SceneError; anything else fails the test. Returns whether it parsed.
bool parsesOrIsRefused(std::string_view text) {
  try {
    parseScene(text, "x.toml");
    return true;
  } catch (const SceneError& e) {
    CHECK_FALSE(e.diagnostics().empty());
    return false;
  }
}

std::string repeated(std::string_view piece, int times) {
  std::string text;
  for (int i = 0; i < times; ++i) text += piece;
  return text;
}

}  // namespace

TEST_CASE("non-ASCII text outside strings and comments is refused with its place") {
  const auto stray = errorsOf("# ä\n[sun]\nelevation = 20 # °\n\tgröße = 3\n[[population]]");
  CHECK(linesOf(stray) == std::vector<std::string>{"4:4 'ö' may stand only in strings and comments"});
  CHECK(errorsOf("[[population]]\nname = \"ä\\\"ö\" # ü").empty());
  CHECK(errorsOf("[[population]]\nname = 'ä\"ö' # ü").empty());
  CHECK(errorsOf("[[population]]\nname = '''ä'ö'''").empty());
  CHECK(errorsOf("[[population]]\nname = \"\"\"ä\"ö\\\"\"\"\"").empty());
  CHECK(linesOf(errorsOf("[[population]]\nname = \"\"\"\nä\"\"\" ö")) ==
        std::vector<std::string>{"3:6 'ö' may stand only in strings and comments"});
  CHECK(linesOf(errorsOf("[[population]]\nname = \"a\\\\\" ö")) ==
        std::vector<std::string>{"2:14 'ö' may stand only in strings and comments"});
}

TEST_CASE("text that is not UTF-8 is refused with its place") {
  const std::vector<std::string> expected{"2:3 the text is not UTF-8 here"};
  CHECK(linesOf(errorsOf("# ä\n# \xff")) == expected);
  CHECK(linesOf(errorsOf("# ä\n# \xc0\xaf")) == expected);          // overlong
  CHECK(linesOf(errorsOf("# ä\n# \xed\xa0\x80")) == expected);      // surrogate
  CHECK(linesOf(errorsOf("# ä\n# \xf4\x90\x80\x80")) == expected);  // above U+10FFFF
  CHECK(linesOf(errorsOf("# ä\n# \xe2\x82")) == expected);          // cut off
}

TEST_CASE("text on which toml++ has undefined behaviour is refused with its place") {
  using Lines = std::vector<std::string>;
  CHECK(linesOf(errorsOf("[=")) == Lines{"1:2 the name of a table is missing here"});
  CHECK(linesOf(errorsOf("[sun]\n [[\n")) == Lines{"2:4 the name of a table is missing here"});
  CHECK(linesOf(errorsOf("[[[a]]]")) == Lines{"1:3 the name of a table is missing here"});
  CHECK(linesOf(errorsOf("a = [1, }")) == Lines{"1:9 '}' cannot close the '[' before it"});
  CHECK(linesOf(errorsOf("a = -1\"é\"")) == Lines{"1:7 a number cannot be followed by '\"'"});
  CHECK(linesOf(errorsOf("a = 1[\"é\"")) == Lines{"1:6 a number cannot be followed by '['"});
  CHECK(errorsOf("['population'.\"x\"]\na-1 = [1.5,-2, +3 ,'é']# é\n").at(0).message.starts_with("'population'"));
}

TEST_CASE("deep nesting is refused before it reaches the parser") {
  for (const std::string& text :
       {"a = " + repeated("[", 500'000), repeated("a.", 200'000) + "a = 1",
        repeated("[a.", 1) + repeated("a.", 200'000) + "a]", "a = " + repeated("{a=", 200'000),
        repeated("\"a\".", 100'000) + "a = 1", repeated("a.b=[{", 1000)}) {
    const auto errors = errorsOf(text);
    REQUIRE(errors.size() == 1);
    CHECK(errors[0].message == "nested more than 16 deep");
    CHECK(errors[0].excerpt.size() < 500);
  }
}

TEST_CASE("a file above one MiB is refused") {
  const std::string comment = std::string("#").append((1 << 20) - 1 - kPopulation.size(), 'x') + '\n';
  CHECK(errorsOf(comment.substr(1) + std::string(kPopulation)).size() == 1);  // not a comment any more
  CHECK(errorsOf(std::string("#").append(comment).append(kPopulation)).at(0).message.starts_with("larger than 1 MiB"));
  CHECK(errorsOf(comment.substr(0, comment.size() - 2) + '\n' + std::string(kPopulation)).empty());
}

TEST_CASE("a file full of errors is reported in full without stalling") {
  std::string text = "sun = { ";
  for (int i = 0; i < 20'000; ++i) text += (i > 0 ? ", k" : "k") + std::to_string(i) + " = 1";
  CHECK(errorsOf(text + " }\n[[population]]").size() == 20'000);
}

TEST_CASE("binary junk is refused") {
  std::mt19937 random(1);
  for (int i = 0; i < 2000; ++i) {
    std::string junk(random() % 300, '\0');
    for (char& c : junk) c = static_cast<char>(random());
    CHECK_FALSE(parsesOrIsRefused(junk));
  }
  CHECK_FALSE(parsesOrIsRefused(std::string(1000, '\0')));
}

TEST_CASE("every prefix of a scene parses or is refused") {
  for (std::size_t length = 0; length <= kExample.size(); ++length) parsesOrIsRefused(kExample.substr(0, length));
  CHECK(parsesOrIsRefused(kExample));
}

TEST_CASE("twenty thousand mutations of a scene parse or are refused") {
  // Bytes that mean something to TOML, and some that mean nothing anywhere.
  constexpr std::string_view kBytes = "\"'[]{}=.,#\\\n\r\t -+_eE019naif\xc3\xa9\xff\x00\x01\x7f";
  std::mt19937 random(20);
  int parsed = 0;
  for (int i = 0; i < 20'000; ++i) {
    std::string text(kExample);
    for (unsigned changes = 1 + random() % 4; changes > 0; --changes) {
      const std::size_t at = random() % text.size();
      const char byte = random() % 4 == 0 ? static_cast<char>(random()) : kBytes[random() % kBytes.size()];
      switch (random() % 4) {
        case 0:
          text[at] = byte;
          break;
        case 1:
          text.insert(at, 1, byte);
          break;
        case 2:
          text.erase(at, 1 + random() % 20);
          break;
        default:
          text.insert(at, text.substr(random() % text.size(), random() % 40));
          break;
      }
    }
    parsed += parsesOrIsRefused(text) ? 1 : 0;
  }
  // Mutations inside comments do no harm, most others do: both must occur.
  CHECK(parsed > 1000);
  CHECK(parsed < 19'000);
}
