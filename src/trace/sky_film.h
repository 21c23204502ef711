// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "image/camera.h"
#include "image/tally.h"
#include "math/exact_sum.h"
#include "trace/bundle_bins.h"
#include "trace/path_tally.h"

namespace parhelion {

/// Exposes a tally through a camera. All threads share one tally and add to it atomically; undeviated light is counted
/// in the tally's info and lands in no pixel.
class SkyFilm : public PathTally {
 public:
  /// `tally` must outlive the film; its info's camera is the one looked through.
  explicit SkyFilm(Tally& tally) : tally_(tally), camera_(tally.info.camera) {}

  void add(std::span<const LightPath> bundle) override;
  std::unique_ptr<PathTally> forThread() override { return std::make_unique<SkyFilm>(tally_); }
  void merge(const PathTally& fromThread) override;

 private:
  Tally& tally_;
  Camera camera_;
  BundleDeposits<Vec3> deposits_;
  std::int64_t intercepted_ = 0, undeviated_ = 0;
};

}  // namespace parhelion
