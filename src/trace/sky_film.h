// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sky/camera.h"
#include "sky/deposit_buffer.h"
#include "sky/tally.h"
#include "trace/bundle_bins.h"
#include "trace/film.h"
#include "trace/intercepted_light.h"

namespace parhelion {

/// Exposes a tally through a camera. All threads share one tally, to which each adds by a buffer of its own: complete
/// once all are merged and finish() has made up for mirror images. Undeviated light is counted in the tally's info and
/// lands in no pixel.
class SkyFilm : public Film {
 public:
  /// `tally` must outlive the film; its info's camera is the one looked through. Where its symmetry is `mirror`, every
  /// ray counts as its mirror image in the sun's vertical plane, too: for clouds that are their own mirror images.
  explicit SkyFilm(Tally& tally) : SkyFilm(tally, std::make_shared<DepositBuffer::Locks>()) {}

  int add(const TracedRays& traced) override;
  std::unique_ptr<Film> forThread() override { return std::unique_ptr<SkyFilm>(new SkyFilm(tally_, locks_)); }
  void merge(Film& fromThread) override;
  void visitSums(SumVisitor& visitor) override;
  void finish() override;
  void reopen() override;
  double fullness() const override { return tally_.fullness(); }

 private:
  /// Through a camera that is its own mirror image, the finished picture makes up for a second view of every exit.
  bool foldsPicture() const { return mirrored_ && camera_.isMirrorSymmetric(); }
  SkyFilm(Tally& tally, std::shared_ptr<DepositBuffer::Locks> locks)
      : tally_(tally),
        mirrored_(tally.info.symmetry == TallySymmetry::mirror),
        camera_(tally.info.camera),
        locks_(std::move(locks)),
        buffer_(tally, locks_),
        folded_(foldsPicture() && !tally.info.rays.empty()) {}

  Tally& tally_;
  bool mirrored_;
  Camera camera_;
  std::shared_ptr<DepositBuffer::Locks> locks_;
  DepositBuffer buffer_;
  BundleDeposits<Vec3> deposits_;
  ByBundle byBundle_;
  SeenLight seen_;
  InterceptedLight intercepted_{tally_};
  bool folded_;  // the tally's picture, by finish(), until reopen()
};

}  // namespace parhelion
