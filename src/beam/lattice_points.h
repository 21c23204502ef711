// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "beam/light_segments.h"

namespace parhelion {

/// Light between two indices, at each of which it fills a quad: at its corners, those of the second side last, its
/// places among rings and its density.
struct SpreadLight {
  struct Quad {
    double place[4], density[4];
  };
  Quad from, to;
};

/// Points of a lattice in spread light, whose places and densities are linear along each side. So many of them follow
/// that light by the rings that it crosses alone; a grid would have as many along each side.
class LatticePoints {
 public:
  /// Points that are made at once.
  static constexpr int kColours = LightSegments::kColours, kMost = 8 * kColours;

  /// `count` points for `share` of the light. The first has the colour `start`, the k-th colourOf(k). `at` says where
  /// between the indices colours are.
  LatticePoints(const SpreadLight& light, double share, int count, const std::array<double, kColours>& at,
                unsigned start);

  /// The next points, up to kMost: how many.
  int next();

  double place(int k) const { return place_[k]; }
  double light(int k) const { return light_[k]; }
  std::size_t colourOf(int k) const { return (start_ + kStep * static_cast<unsigned>(k)) % kColours; }

 private:
  static constexpr unsigned kStep = 5;
  void fill(int first);

  // By lane: constant, along both sides, across both; of places, then of light.
  alignas(32) double coefficients_[8][kColours];
  alignas(32) double place_[kMost], light_[kMost];
  double turn_, perCount_;
  int count_, done_ = 0;
  unsigned start_;
};

}  // namespace parhelion
