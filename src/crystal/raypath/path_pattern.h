// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "crystal/raypath/stance.h"

namespace parhelion {

/// Which raypaths count as one: those that the crystal's own symmetry takes to each other; of these, only those that
/// are equally likely however the crystals stand (a plate's 1-3 and 3-2 are not); or none.
enum class PathSymmetry { crystal, orientation, none };

constexpr std::string_view nameOf(PathSymmetry value) {
  switch (value) {
    case PathSymmetry::crystal:
      return "crystal";
    case PathSymmetry::orientation:
      return "orientation";
    case PathSymmetry::none:
      return "none";
  }
  return {};
}

/// Faces by their crystallographic number.
struct FaceChoice {
  bool any = true;
  std::vector<int> numbers;  // where not any

  bool has(int number) const;
};

/// What is wrong with a pattern, and where: `length` bytes from byte `at` on.
class PatternError : public std::invalid_argument {
 public:
  PatternError(std::size_t place, std::size_t bytes, const std::string& message, std::string word = {},
               std::vector<std::string_view> accepted = {})
      : std::invalid_argument(message),
        at(place),
        length(bytes),
        unknownWord(std::move(word)),
        acceptedWords(std::move(accepted)) {}

  std::size_t at, length;
  std::string unknownWord;  // with the words that could stand there; else empty
  std::vector<std::string_view> acceptedWords;
};

/// A set of raypaths as people write it. The grammar, spaces being free:
///
///   pattern = (["not"] [chain] | names) {("," | ";") clause}
///   names   = (name of a halo | links) {"|" (name of a halo | links)}     at least one of them a name
///   chain   = links {"|" links}
///   links   = link {"-" link}
///   link    = face number | "?" | "*" | class | "(" chain ")"
///   class   = "basal" | "prism" | "pyramid" | "upper" | "lower"
///   clause  = "hits" "=" (N | N ".." | ".." N | N ".." N)     faces met, entry and exit among them
///           | "entry" "=" chain of single faces  | "exit" "=" chain of single faces
///           | "population" "=" name {"|" name}   | "symmetry" "=" ("crystal" | "orientation" | "none")
///
/// "?" is any one face, "*" any chain of faces, also none. "not" turns the chain with hits, entry and exit around.
struct PathPattern {
  /// One place of the chain that is taken by one face, and the places that may come next.
  struct Place {
    FaceChoice faces;
    std::vector<int> next;
    bool isLast = false;
  };

  std::string text;  // as it was written
  std::vector<Place> places;
  std::vector<int> first;
  bool isInverted = false;
  int fewestHits = 1, mostHits = std::numeric_limits<int>::max();
  FaceChoice entry, exit;
  std::vector<std::string> populations;  // empty: all
  std::vector<Stance> stances;           // of the crystals that make a halo of this name; empty: all
  std::vector<PathPattern> others;       // of the same halo in crystals of other stances, and alternatives to its name
  PathSymmetry symmetry = PathSymmetry::orientation;

  bool operator==(const PathPattern& other) const { return text == other.text; }
};

/// Longer patterns are refused, and more hits, places or brackets in brackets: an automaton has to count them.
inline constexpr std::size_t kMostPatternBytes = 10'000;
inline constexpr int kMostPatternHits = 255;
inline constexpr std::size_t kMostPatternPlaces = 256;
inline constexpr int kDeepestPattern = 32;

/// Throws PatternError.
PathPattern parsePathPattern(std::string_view text);

/// All raypaths.
PathPattern anyPath();

}  // namespace parhelion
