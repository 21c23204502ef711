// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <utility>

#include "sky/tally.h"
#include "trace/bundle_bins.h"
#include "trace/film.h"
#include "trace/intercepted_light.h"

namespace parhelion {

/// Exposes rings about the sun's centre, for clouds in random orientation: every ray counts for whole rings of the sky.
/// Undeviated light is in no ring.
class RadialFilm : public Film {
 public:
  /// `tally` must outlive the film and stay where it is. The sun's centre is toward `toSun` (unit, world).
  RadialFilm(Tally& tally, const Vec3& toSun) : tally_(tally), sky_(tally.makeRings(toSun)) {}

  int add(const TracedRays& traced) override;
  std::unique_ptr<Film> forThread() override {
    return std::unique_ptr<RadialFilm>(
        new RadialFilm(tally_, std::make_unique<RadialSky>(tally_.info, sky_.toCentre(), tally_.colours())));
  }
  void merge(Film& fromThread) override;
  void visitSums(SumVisitor& visitor) override;

  /// Spreads the rings over the tally's pixels, in the place of what was there.
  void finish() override { sky_.spreadOver(tally_); }
  double fullness() const override { return tally_.fullness(); }

 private:
  /// A thread has rings of its own.
  RadialFilm(Tally& tally, std::unique_ptr<RadialSky> own) : tally_(tally), own_(std::move(own)), sky_(*own_) {}

  Tally& tally_;
  std::unique_ptr<RadialSky> own_;  // none: the rings are the tally's
  RadialSky& sky_;
  BundleDeposits<Vec3> deposits_;
  ByBundle byBundle_;
  InterceptedLight intercepted_{tally_};
};

}  // namespace parhelion
