// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "beam/tristimulus.h"

namespace parhelion {

/// A refractive index, the share of all light that meets it, and the colour of light there: XYZ of a unit of it.
struct IndexShare {
  double index, share;
  Tristimulus xyz{1.0, 1.0, 1.0};
};

/// The refractive indices that light of a spectrum meets in ice.
///
/// What gets to an exit changes slowly with the index, where it goes does not. So a prism is traced at a few indices,
/// the nodes, and all others lie between them.
class IceLight {
 public:
  /// Lines, each traced by itself; their shares add up to 1. Throws std::invalid_argument without any.
  explicit IceLight(const std::vector<IndexShare>& lines);

  /// Continuous light: its indices at evenly spaced shares of it, from 0 to 1, rising or falling, and its colours
  /// there; all are (1, 1, 1) where there are none.
  static IceLight continuous(std::vector<double> indexAtShares, std::vector<Tristimulus> colours = {});

  /// At most so many nodes are mixed for an index.
  static constexpr int kMixed = 3;

  /// An index that stands for a share of the light, and what of which node makes its light.
  struct Sample {
    double index, share;
    Tristimulus xyz;
    std::array<int, kMixed> node;
    std::array<double, kMixed> part;
  };

  /// Samples whose shares add up to 1. Of continuous light they are evenly spaced, the first so far (0 to 1) on the way
  /// to the second; lines are what they are.
  void sample(double start, std::vector<Sample>& samples) const;

  bool isContinuous() const { return !continuous_.empty(); }
  const std::vector<double>& nodes() const { return nodes_; }

  /// What of each node makes all light (Y) together.
  const std::vector<double>& nodeShares() const { return nodeShares_; }

 private:
  IceLight() = default;
  Sample between(double index, double share, const Tristimulus& xyz) const;

  std::vector<double> nodes_, nodeShares_, continuous_;
  std::vector<Tristimulus> colours_;  // of continuous light
  Tristimulus white_{};               // their mean
  std::vector<IndexShare> lines_;
};

}  // namespace parhelion
