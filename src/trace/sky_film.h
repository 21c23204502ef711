// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "image/camera.h"
#include "image/deposit_buffer.h"
#include "image/tally.h"
#include "math/exact_sum.h"
#include "trace/bundle_bins.h"
#include "trace/path_tally.h"

namespace parhelion {

/// Exposes a tally through a camera. All threads share one tally, to which each adds by a buffer of its own: complete
/// once all are merged. Undeviated light is counted in the tally's info and lands in no pixel.
class SkyFilm : public PathTally {
 public:
  /// `tally` must outlive the film; its info's camera is the one looked through.
  explicit SkyFilm(Tally& tally) : SkyFilm(tally, std::make_shared<DepositBuffer::Locks>()) {}

  void add(const TracedRays& traced) override;
  std::unique_ptr<PathTally> forThread() override { return std::unique_ptr<SkyFilm>(new SkyFilm(tally_, locks_)); }
  void merge(PathTally& fromThread) override;

 private:
  SkyFilm(Tally& tally, std::shared_ptr<DepositBuffer::Locks> locks)
      : tally_(tally), camera_(tally.info.camera), locks_(std::move(locks)), buffer_(tally, locks_) {}

  Tally& tally_;
  Camera camera_;
  std::shared_ptr<DepositBuffer::Locks> locks_;
  DepositBuffer buffer_;
  BundleDeposits<Vec3> deposits_;
  ExitsByBundle byBundle_;
  std::vector<std::int32_t> pixel_;  // of each exit
  std::int64_t intercepted_ = 0, undeviated_ = 0;
};

}  // namespace parhelion
