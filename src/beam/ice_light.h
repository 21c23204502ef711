// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace parhelion {

/// A refractive index and the share of all light that meets it.
struct IndexShare {
  double index, share;
};

/// The refractive indices that light of a spectrum meets in ice.
///
/// What gets to an exit changes slowly with the index, where it goes does not. So a prism is traced at a few indices,
/// the nodes, and all others lie between them. Where light of some more indices goes is worked out, and of all others
/// lies between these.
class IceLight {
 public:
  /// Lines, each traced by itself; their shares add up to 1. Throws std::invalid_argument without any.
  explicit IceLight(const std::vector<IndexShare>& lines);

  /// Continuous light: its indices at evenly spaced shares of it, from 0 to 1, rising or falling.
  static IceLight continuous(const std::vector<double>& indexAtShares);

  /// At most so many nodes are mixed for an index.
  static constexpr int kMixed = 3;

  /// An index, and what of which node makes its light.
  struct Sample {
    double index;
    std::array<int, kMixed> node;
    std::array<double, kMixed> part;
  };

  /// Light between two samples, the same one for a line.
  struct Segment {
    static constexpr std::size_t kPlaces = 32;

    std::size_t from, to;
    double share;                    // of all light
    std::array<double, kPlaces> at;  // places on the way between both, from 0 to 1, of as much light each

    bool isLine() const { return from == to; }
  };

  const std::vector<Sample>& samples() const { return samples_; }

  /// All light; of two successive ones the second begins where the first ends, or at the next line.
  const std::vector<Segment>& segments() const { return segments_; }

  bool isContinuous() const { return !segments_.front().isLine(); }
  const std::vector<double>& nodes() const { return nodes_; }

  /// What of each node makes all light together.
  const std::vector<double>& nodeShares() const { return nodeShares_; }

 private:
  IceLight() = default;
  Sample between(double index) const;

  std::vector<double> nodes_, nodeShares_;
  std::vector<Sample> samples_;
  std::vector<Segment> segments_;
};

}  // namespace parhelion
