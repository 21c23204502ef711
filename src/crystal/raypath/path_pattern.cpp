// SPDX-License-Identifier: Apache-2.0
#include "crystal/raypath/path_pattern.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <iterator>
#include <utility>

#include "crystal/raypath/halo_paths.h"
#include "math/names.h"

namespace parhelion {

namespace {

struct FaceClass {
  std::string_view name;
  std::vector<int> numbers;
};

const std::vector<FaceClass>& faceClasses() {
  static const std::vector<FaceClass> classes{
      {"basal", {1, 2}},
      {"prism", {3, 4, 5, 6, 7, 8}},
      {"pyramid", {13, 14, 15, 16, 17, 18, 23, 24, 25, 26, 27, 28}},
      {"upper", {1, 13, 14, 15, 16, 17, 18}},
      {"lower", {2, 23, 24, 25, 26, 27, 28}},
  };
  return classes;
}

// Each is an automaton of its own.
constexpr std::size_t kMostAlternatives = 64;

constexpr std::array<std::string_view, 5> kClauses{"hits", "entry", "exit", "population", "symmetry"};

bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '\'' || c < 0; }
bool isDigit(char c) { return c >= '0' && c <= '9'; }
bool isSpace(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
bool isSeparator(char c) { return c == ',' || c == ';'; }

/// Part of a chain: where it begins and ends, and whether it may be left out. (Glushkov's construction.)
struct Links {
  std::vector<int> first, last;
  bool mayBeEmpty = false;
};

void append(std::vector<int>& to, const std::vector<int>& more) {
  for (const int place : more)
    if (std::ranges::find(to, place) == to.end()) to.push_back(place);
}

class PatternParser {
 public:
  explicit PatternParser(std::string_view text) : text_(text) { pattern_.text = text; }

  PathPattern parse() {
    skipSpaces();
    if (!takeNames()) {
      pattern_.isInverted = takeWord("not");
      skipSpaces();
      const bool hasChain = !atEnd() && !isSeparator(peek()) && !startsClause();
      if (!hasChain && (atEnd() || isSeparator(peek()))) face();  // which complains
      setChain(hasChain ? chain(0) : anyChain());
    }
    skipSpaces();
    if (!atEnd() && !isSeparator(peek()) && !startsClause()) failAt("'-', '|', ',' or the end should stand here");
    while (!atEnd()) {
      if (isSeparator(peek())) ++at_;
      skipSpaces();
      clause();
      skipSpaces();
      if (!atEnd() && !isSeparator(peek()) && !startsClause()) failAt("',' or the end should stand here");
    }
    // What clauses say holds for a halo in crystals of any stance.
    for (PathPattern& other : pattern_.others) {
      other.fewestHits = std::max(other.fewestHits, pattern_.fewestHits);
      other.mostHits = std::min(other.mostHits, pattern_.mostHits);
      if (!pattern_.entry.any) other.entry = pattern_.entry;
      if (!pattern_.exit.any) other.exit = pattern_.exit;
      other.populations = pattern_.populations;
      if (saysSymmetry_) other.symmetry = pattern_.symmetry;
    }
    return std::move(pattern_);
  }

 private:
  // Characters and words.

  bool atEnd() const { return at_ == text_.size(); }
  char peek() const { return text_[at_]; }
  void skipSpaces() {
    while (!atEnd() && isSpace(peek())) ++at_;
  }
  bool take(char c) {
    skipSpaces();
    if (atEnd() || peek() != c) return false;
    ++at_;
    return true;
  }
  /// The word here, which it leaves where it is.
  std::string_view word() const {
    std::size_t end = at_;
    while (end < text_.size() && isLetter(text_[end])) ++end;
    return text_.substr(at_, end - at_);
  }
  bool takeWord(std::string_view wanted) {
    skipSpaces();
    if (word() != wanted) return false;
    at_ += wanted.size();
    return true;
  }
  bool startsClause() const {
    std::size_t i = at_ + word().size();
    if (i == at_) return false;
    while (i < text_.size() && isSpace(text_[i])) ++i;
    return i < text_.size() && text_[i] == '=';
  }

  [[noreturn]] void failAt(const std::string& message) const {
    const std::string what = atEnd() ? "the pattern ends here, and " : "";
    throw PatternError(at_, atEnd() ? 1 : std::max<std::size_t>(1, word().size()), what + message);
  }
  [[noreturn]] void failWith(std::string_view unknown, const std::string& message,
                             std::vector<std::string_view> accepted) const {
    throw PatternError(at_, unknown.size(), message, std::string(unknown), std::move(accepted));
  }

  // Names of halos, of which some may be chains.

  /// All words up to a separator, and up to '|' outside of brackets.
  std::size_t endOfAlternative(std::size_t begin) const {
    int depth = 0;
    std::size_t end = begin;
    for (; end < text_.size() && !isSeparator(text_[end]); ++end) {
      if (text_[end] == '(') ++depth;
      if (text_[end] == ')') --depth;
      if (text_[end] == '|' && depth == 0) break;
    }
    return end;
  }

  std::vector<PathPattern> halosIn(std::size_t begin, std::size_t end) const {
    while (begin < end && isSpace(text_[begin])) ++begin;
    while (end > begin && isSpace(text_[end - 1])) --end;
    std::vector<PathPattern> known;
    for (const HaloPath* halo : halosNamed(text_.substr(begin, end - begin))) {
      known.push_back(parsePathPattern(halo->pattern));
      known.back().stances = halo->stances;
    }
    return known;
  }

  /// Takes alternatives if one of them is a halo's name: each becomes a pattern of its own.
  bool takeNames() {
    struct Alternative {
      std::size_t begin, end;
      std::vector<PathPattern> halos;  // empty: a chain
    };
    std::vector<Alternative> alternatives;
    std::size_t begin = at_, end = 0;
    do {
      end = endOfAlternative(begin);
      alternatives.push_back({begin, end, halosIn(begin, end)});
      begin = end + 1;
    } while (end < text_.size() && text_[end] == '|');
    if (std::ranges::all_of(alternatives, [](const Alternative& one) { return one.halos.empty(); })) return false;
    std::vector<PathPattern> all;
    for (Alternative& one : alternatives) {
      if (one.halos.empty()) one.halos.push_back(chainIn(one.begin, one.end));
      std::ranges::move(one.halos, std::back_inserter(all));
    }
    if (all.size() > kMostAlternatives) failAt("too many alternatives beside names of halos");
    std::string text = std::move(pattern_.text);
    pattern_ = std::move(all.front());
    pattern_.text = std::move(text);
    pattern_.others.assign(std::make_move_iterator(all.begin() + 1), std::make_move_iterator(all.end()));
    at_ = end;
    return true;
  }

  /// The chain that is an alternative to names.
  PathPattern chainIn(std::size_t begin, std::size_t end) const {
    PatternParser part(text_.substr(0, end));
    part.at_ = begin;
    part.skipSpaces();
    part.setChain(part.chain(0));
    part.skipSpaces();
    if (!part.atEnd()) part.failAt("'-', '|', ',' or the end should stand here");
    return std::move(part.pattern_);
  }

  // Chains.

  void setChain(const Links& links) {
    pattern_.first = links.first;
    for (const int place : links.last) pattern_.places[place].isLast = true;
  }

  int newPlace(FaceChoice faces) {
    if (pattern_.places.size() == kMostPatternPlaces)
      failAt("a pattern may name " + std::to_string(kMostPatternPlaces) + " faces at the most");
    pattern_.places.push_back({std::move(faces), {}, false});
    return static_cast<int>(pattern_.places.size()) - 1;
  }

  Links anyChain() {
    const int place = newPlace({});
    pattern_.places[place].next = {place};
    return {{place}, {place}, true};
  }
  Links oneOf(FaceChoice faces) {
    const int place = newPlace(std::move(faces));
    return {{place}, {place}, false};
  }

  Links chain(int depth) {
    Links all = links(depth);
    while (take('|')) {
      const Links more = links(depth);
      append(all.first, more.first);
      append(all.last, more.last);
      all.mayBeEmpty |= more.mayBeEmpty;
    }
    return all;
  }

  Links links(int depth) {
    Links all = link(depth);
    while (take('-')) {
      const Links more = link(depth);
      for (const int place : all.last) append(pattern_.places[place].next, more.first);
      if (all.mayBeEmpty) append(all.first, more.first);
      if (more.mayBeEmpty)
        append(all.last, more.last);
      else
        all.last = more.last;
      all.mayBeEmpty &= more.mayBeEmpty;
    }
    return all;
  }

  Links link(int depth) {
    if (take('*')) return anyChain();
    if (take('?')) return oneOf({});
    if (take('(')) {
      if (depth == kDeepestPattern) failAt("too many brackets in brackets");
      const Links inside = chain(depth + 1);
      if (!take(')')) failAt("')' should stand here");
      return inside;
    }
    return oneOf(face());
  }

  /// A face number or a class.
  FaceChoice face() {
    skipSpaces();
    if (!atEnd() && isDigit(peek())) return {false, {faceNumber()}};
    const std::string_view name = word();
    if (name.empty())
      failAt("a face should stand here: a number, '?', '*', '(' or one of basal, prism, pyramid, upper, lower");
    for (const FaceClass& one : faceClasses())
      if (one.name == name) {
        at_ += name.size();
        return {false, one.numbers};
      }
    // Of a halo that is not known all of the words are the name.
    std::size_t end = at_;
    while (end < text_.size() && !isSeparator(text_[end]) &&
           std::string_view("|()-").find(text_[end]) == std::string_view::npos)
      ++end;
    while (end > at_ && isSpace(text_[end - 1])) --end;
    std::vector<std::string_view> accepted = haloNames();
    for (const FaceClass& one : faceClasses()) accepted.push_back(one.name);
    const std::string_view unknown = text_.substr(at_, end - at_);
    failWith(unknown, "'" + std::string(unknown) + "' is neither a kind of face nor the name of a halo",
             std::move(accepted));
  }

  int number(int most, const char* what) {
    skipSpaces();
    int value = 0;
    const char* begin = text_.data() + at_;
    const auto [end, error] = std::from_chars(begin, text_.data() + text_.size(), value);
    if (end == begin || *begin == '-') failAt(std::string("a number should stand here: ") + what);
    if (error != std::errc{} || value < 1 || value > most)
      throw PatternError(at_, static_cast<std::size_t>(end - begin),
                         std::string(what) + " must be from 1 to " + std::to_string(most));
    at_ += static_cast<std::size_t>(end - begin);
    return value;
  }

  int faceNumber() {
    constexpr int kMostFaceNumber = 999;
    return number(kMostFaceNumber, "a face number");
  }

  // Clauses.

  void clause() {
    const std::string_view name = word();
    if (std::ranges::find(kClauses, name) == kClauses.end()) {
      if (name.empty()) failAt("hits, entry, exit, population or symmetry should stand here");
      failWith(name, "'" + std::string(name) + "' is none of hits, entry, exit, population, symmetry",
               {kClauses.begin(), kClauses.end()});
    }
    at_ += name.size();
    if (!take('=')) failAt("'=' should stand here");
    skipSpaces();
    if (name == "hits") return hits();
    if (name == "entry") return faces(pattern_.entry);
    if (name == "exit") return faces(pattern_.exit);
    if (name == "population") return populations();
    symmetry();
  }

  bool takeRange() {
    skipSpaces();
    if (text_.substr(at_, 2) != "..") return false;
    at_ += 2;
    return true;
  }

  void hits() {
    const std::size_t begin = at_;
    if (takeRange()) {
      pattern_.mostHits = number(kMostPatternHits, "the number of hits");
      return;
    }
    pattern_.fewestHits = pattern_.mostHits = number(kMostPatternHits, "the number of hits");
    if (!takeRange()) return;
    skipSpaces();
    pattern_.mostHits =
        !atEnd() && isDigit(peek()) ? number(kMostPatternHits, "the number of hits") : std::numeric_limits<int>::max();
    if (pattern_.mostHits < pattern_.fewestHits)
      throw PatternError(begin, at_ - begin, "the range of hits ends before it begins");
  }

  void faces(FaceChoice& choice) {
    choice = {false, {}};
    const bool inBrackets = take('(');
    do {
      if (take('?') || take('*')) {
        choice.any = true;
        continue;
      }
      const FaceChoice more = face();
      choice.numbers.insert(choice.numbers.end(), more.numbers.begin(), more.numbers.end());
    } while (take('|'));
    if (inBrackets && !take(')')) failAt("')' should stand here");
  }

  void populations() {
    do {
      skipSpaces();
      std::size_t begin = at_;
      if (!atEnd() && (peek() == '"' || peek() == '\'')) {
        const std::size_t end = text_.find(peek(), at_ + 1);
        if (end == std::string_view::npos) failAt("the name that begins here has no end");
        pattern_.populations.emplace_back(text_.substr(begin + 1, end - begin - 1));
        at_ = end + 1;
        continue;
      }
      while (!atEnd() && !isSeparator(peek()) && peek() != '|' && !isSpace(peek())) ++at_;
      if (at_ == begin) failAt("the name of a population should stand here");
      pattern_.populations.emplace_back(text_.substr(begin, at_ - begin));
    } while (take('|'));
  }

  void symmetry() {
    const std::string_view name = word();
    const auto found = memberNamed<PathSymmetry>(name);
    if (!found) {
      if (name.empty()) failAt("crystal, orientation or none should stand here");
      failWith(name, "'" + std::string(name) + "' is none of crystal, orientation, none",
               acceptedNames<PathSymmetry>());
    }
    pattern_.symmetry = *found;
    saysSymmetry_ = true;
    at_ += name.size();
  }

  std::string_view text_;
  std::size_t at_ = 0;
  bool saysSymmetry_ = false;
  PathPattern pattern_;
};

}  // namespace

bool FaceChoice::has(int number) const { return any || std::ranges::find(numbers, number) != numbers.end(); }

PathPattern parsePathPattern(std::string_view text) { return PatternParser(text).parse(); }

PathPattern anyPath() { return parsePathPattern("*"); }

}  // namespace parhelion
