// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include "trace/cloud.h"

namespace parhelion::bench {

/// Light on its way to the film.
struct SkyDeposit {
  Vec3 toSky;  // unit, world
  double luminance;
  bool firstHalf;
};

/// The first `count` deposits of a real run.
std::vector<SkyDeposit> skyDeposits(const Cloud& cloud, int count);

/// The same light by the pixel of a film of the whole sky.
struct PixelDeposit {
  double luminance;
  int pixel;
  bool firstHalf;
};
std::vector<PixelDeposit> throughCamera(const std::vector<SkyDeposit>& deposits, int side);

/// How threads share the tally of one picture.
enum class Sharing { bands, atomics, privateTallies };

struct SharingName {
  Sharing sharing;
  std::string_view id, label;
};
inline constexpr std::array<SharingName, 3> kSharings{{
    {Sharing::bands, "bands", "one tally in buffered bands"},
    {Sharing::atomics, "atomics", "one tally of atomic sums"},
    {Sharing::privateTallies, "private", "a tally for each thread"},
}};

struct DepositSpeed {
  std::size_t deposits = 0;
  double seconds = 0.0;       // wall clock, of the depositing
  double fixedSeconds = 0.0;  // of making the tallies and merging them
  std::size_t memory = 0;     // bytes, peak above what was held before

  double perSecond() const { return static_cast<double>(deposits) / seconds; }

  /// Deposits a second of a run of a hundred million, making the tallies and merging them included.
  double runPerSecond() const { return 1.0 / (1.0 / perSecond() + fixedSeconds / 1e8); }
};

/// Adds each deposit `passes` times to a tally of `side` x `side` pixels, from several threads.
DepositSpeed depositBy(Sharing sharing, const std::vector<PixelDeposit>& deposits, int passes, int side, int threads);

/// Tallies that a way of sharing holds at a time.
inline int talliesOf(Sharing sharing, int threads) { return sharing == Sharing::privateTallies ? threads : 1; }

}  // namespace parhelion::bench
