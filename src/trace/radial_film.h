// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sky/radial_sky.h"
#include "trace/bundle_bins.h"
#include "trace/film.h"
#include "trace/intercepted_light.h"

namespace parhelion {

/// Exposes rings about the sun's centre, for clouds in random orientation: every ray counts for whole rings of the sky.
/// Undeviated light is in no ring.
class RadialFilm : public Film {
 public:
  /// `tally` must outlive the film. The sun's centre is toward `toSun` (unit, world).
  RadialFilm(Tally& tally, const Vec3& toSun)
      : tally_(tally), toSun_(toSun), sky_(tally.info, toSun, tally.colours()) {}

  int add(const TracedRays& traced) override;
  std::unique_ptr<Film> forThread() override { return std::make_unique<RadialFilm>(tally_, toSun_); }
  void merge(Film& fromThread) override;

  /// Spreads the rings over the tally's pixels, in the place of what was there.
  void finish() override { sky_.spreadOver(tally_); }
  double fullness() const override { return tally_.fullness(); }

 private:
  Tally& tally_;
  Vec3 toSun_;
  RadialSky sky_;
  BundleDeposits<Vec3> deposits_;
  ByBundle byBundle_;
  InterceptedLight intercepted_;
};

}  // namespace parhelion
