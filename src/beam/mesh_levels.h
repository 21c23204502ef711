// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

namespace parhelion {

/// Meshes that get finer, level by level, until what is integrated is good enough.
struct MeshLevels {
  double firstError;  // of the mesh of level 0, more or less
  double better;      // by how much less each of the next errs
  int most;           // the last level

  /// The first level that is likely to err by no more than this.
  int firstFor(double error) const { return levelsFrom(firstError, error); }

  /// Levels between one that errs by so much and that which is likely to err by no more than this, `most` at most.
  int levelsFrom(double from, double error) const {
    return static_cast<int>(std::clamp(std::ceil(std::log(from / error) / std::log(better)), 0.0, double(most)));
  }
};

}  // namespace parhelion
