// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <mutex>
#include <vector>

#include "sky/ray_ranges.h"

namespace parhelion {

/// Deals the rays of a range to ranks, block after block from the first ray on. All blocks dealt make one gapless
/// range. Safe to use from any number of threads at once.
class BlockDeal {
 public:
  /// `bundleSize` rays are never parted, except at the range's end.
  BlockDeal(const RayRange& range, std::uint64_t bundleSize, int ranks);

  /// The next block for a rank: about a fifth of a second's work, and less toward the end, so that all ranks end at the
  /// same time. Empty when all is dealt, or after close().
  RayRange next(int rank);

  /// A rank's last block of so many rays took so long.
  void note(int rank, std::uint64_t rays, double seconds);

  /// Deals no more.
  void close();

  /// Rays of all blocks that are dealt, and of those that note() told of.
  std::uint64_t dealt() const;
  std::uint64_t done() const;

 private:
  mutable std::mutex mutex_;
  RayRange left_;
  std::uint64_t bundleSize_, first_, done_ = 0;
  std::vector<double> raysPerSecond_;  // by rank; 0 as long as nothing is known
};

}  // namespace parhelion
