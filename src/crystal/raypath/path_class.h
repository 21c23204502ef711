// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <compare>
#include <optional>
#include <string>
#include <vector>

#include "crystal/crystal_mesh.h"
#include "crystal/raypath/path_code.h"

namespace parhelion {

/// Raypaths that a symmetry of a crystal takes to each other, by the one whose face numbers come first. Paths of more
/// than kLongest faces are told apart by their first and last face alone.
struct PathClass {
  std::vector<int> faces;  // indices into the mesh: all, or the first and the last of a long path
  bool isLong = false;

  auto operator<=>(const PathClass&) const = default;
};

/// The classes of one crystal's paths.
class PathClasses {
 public:
  static constexpr int kLongest = 10;

  /// `images` are those of the symmetry (path_symmetry.h).
  PathClasses(const CrystalMesh& mesh, std::vector<std::vector<int>> images);

  PathClass of(const PathCode::Words& words, int count) const;

  /// As a pattern: "3-1-5", "3-*-5, hits = 11.."
  std::string text(const PathClass& path) const;

  /// The least angle (rad) by which light is deviated that takes such a path in ice of this index. None for long paths,
  /// for those on which reflections inside turn the light, and where light does not pass.
  std::optional<double> leastDeviation(const PathClass& path, double index) const;

 private:
  const CrystalMesh* mesh_;
  std::vector<std::vector<int>> images_;
  PathCode code_;
  std::vector<int> rank_;  // of faces by their numbers
};

}  // namespace parhelion
