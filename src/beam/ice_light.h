// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

namespace parhelion {

/// A refractive index, and the share of all light that meets it.
struct IndexShare {
  double index, share;
};

/// The refractive indices that light of a spectrum meets in ice.
///
/// What gets to an exit changes slowly with the index, where it goes does not. So a prism is traced at a few indices,
/// the nodes, and all others lie between them.
class IceLight {
 public:
  /// Lines, each traced by itself; their shares add up to 1. Throws std::invalid_argument without any.
  explicit IceLight(const std::vector<IndexShare>& lines);

  /// Continuous light: its indices at evenly spaced shares of it, from 0 to 1, rising or falling.
  static IceLight continuous(std::vector<double> indexAtShares);

  /// At most so many nodes are mixed for an index.
  static constexpr int kMixed = 3;

  /// An index that stands for a share of the light, and what of which node makes its light.
  struct Sample {
    double index, share;
    std::array<int, kMixed> node;
    std::array<double, kMixed> part;
  };

  /// Samples whose shares add up to 1. Of continuous light they are evenly spaced, the first so far (0 to 1) on the way
  /// to the second; lines are what they are.
  void sample(double start, std::vector<Sample>& samples) const;

  bool isContinuous() const { return !continuous_.empty(); }
  const std::vector<double>& nodes() const { return nodes_; }

  /// What of each node makes all light together.
  const std::vector<double>& nodeShares() const { return nodeShares_; }

 private:
  IceLight() = default;
  Sample between(double index, double share) const;

  std::vector<double> nodes_, nodeShares_, continuous_;
  std::vector<IndexShare> lines_;
};

}  // namespace parhelion
