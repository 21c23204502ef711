// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>

#include "recon/reconstruct.h"
#include "render/sky_sums.h"

namespace parhelion {

/// The picture of a run's rays, which is made once also where its error is measured first.
class Development {
 public:
  /// All that is referred to must outlive it. `threads` 0: one a processor.
  Development(SkySums& sums, const LoadedScene& loaded, int threads)
      : sums_(sums), loaded_(loaded), threads_(threads) {}

  /// The picture's error (pictureError()) as of the rays held now. None if it was stopped.
  std::optional<double> error(const std::atomic<bool>* stop);

  /// The picture that was made last.
  const Image& image() const { return sky_->image; }

  /// The picture of all rays held, made unless it is.
  ReconstructedSky take();

 private:
  void develop(const Watch& watch);

  SkySums& sums_;
  const LoadedScene& loaded_;
  int threads_;
  std::optional<ReconstructedSky> sky_;
  std::uint64_t rays_ = 0;  // that it was made of
};

}  // namespace parhelion
