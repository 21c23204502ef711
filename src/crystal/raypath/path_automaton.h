// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bitset>
#include <cstddef>
#include <span>
#include <vector>

#include "crystal/raypath/path_pattern.h"

namespace parhelion {

/// A pattern with the images of a crystal's faces under its symmetry (path_symmetry.h).
struct SymmetricPattern {
  const PathPattern* pattern;
  std::vector<std::vector<int>> images;
};

/// The most faces of crystals whose paths patterns may speak of; others have no patterns.
inline constexpr int kMostPatternFaces = 128;

/// Tells which of some patterns take a raypath, face by face: a number stands for all that was met so far, and one
/// look into a table makes the next one. Populations and stances of the patterns are not looked at.
class PathAutomaton {
 public:
  static constexpr std::size_t kMostPatterns = 65;  // layers and a filter

  /// Pattern i is bit i.
  using Patterns = std::bitset<kMostPatterns>;

  /// More would not stay in the second-level cache.
  static constexpr int kMostStates = 4096;

  /// For crystals whose faces have these numbers. Throws std::invalid_argument for too many patterns, or where they are
  /// too intricate together.
  PathAutomaton(std::span<const int> faceNumbers, std::span<const SymmetricPattern> patterns);

  int states() const { return static_cast<int>(accepted_.size()); }
  int faces() const { return faces_; }

  /// Before the first face.
  static constexpr int kStart = 0;

  int next(int state, int face) const { return static_cast<int>(next_[state * faces_ + face]); }

  /// The patterns that take what was met so far.
  const Patterns& accepted(int state) const { return accepted_[state]; }

  /// The table as numbers that lanes can run on: of states * faces.
  const std::vector<double>& table() const { return next_; }

  /// Of a whole path, by indices of faces.
  Patterns acceptedAfter(std::span<const int> faces) const;

 private:
  int faces_;
  std::vector<double> next_;
  std::vector<Patterns> accepted_;
};

}  // namespace parhelion
