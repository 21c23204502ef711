// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "beam/tristimulus.h"
#include "math/aligned_vector.h"
#include "math/lanes.h"

namespace parhelion {

/// Light in equal bins of an angle, added in triangles. Each bin has sums of X, Y and Z.
class AngleBins {
 public:
  /// `bins` of them over [from, to] (rad); light outside falls into none.
  AngleBins(int bins, double from, double to)
      : from_(from), perBin_(bins / (to - from)), light_(static_cast<std::size_t>(bins)) {}

  /// Adds light of a colour at one angle.
  void add(double angle, double light, const Tristimulus& xyz) {
    const double place = (angle - from_) * perBin_;
    if (place >= 0.0 && place <= size())
      light_[static_cast<std::size_t>(place < size() ? place : size() - 1.0)] += light * sumsOf(xyz);
  }

  /// Adds the light of a triangle, across which both angle and density are linear, from their values at its corners.
  /// The mean of the densities is all its light.
  void addTriangle(const double* angle, const double* density, const Tristimulus& xyz);

  std::size_t bins() const { return light_.size(); }

  /// One sum of a bin: 0 to 2 for X, Y and Z.
  double light(std::size_t bin, int sum = 1) const { return light_[bin][sum]; }

 private:
  using Four = Lanes<4>::Real;

  static PARHELION_INLINE Four sumsOf(const Tristimulus& xyz) { return Four{xyz[0], xyz[1], xyz[2], 0.0}; }
  double size() const { return static_cast<double>(light_.size()); }

  double from_, perBin_;
  AlignedVector<Four> light_;
};

}  // namespace parhelion
