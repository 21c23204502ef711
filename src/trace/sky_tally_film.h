// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "sky/sky_tally.h"
#include "trace/cloud.h"
#include "trace/film.h"
#include "trace/intercepted_light.h"

namespace parhelion {

/// Exposes all parts of a tally: light of each population by what its rays count for, and of each layer.
class SkyTallyFilm : public Film {
 public:
  /// `tally` must outlive the film and stay where it is, and have the symmetries of the populations, of which there is
  /// one for each of the cloud, whose sun's centre is toward `toSun` (unit, world).
  SkyTallyFilm(SkyTally& tally, const std::vector<TallySymmetry>& ofPopulations, const Vec3& toSun);

  int add(const TracedRays& traced) override;
  std::unique_ptr<Film> forThread() override;
  void merge(Film& fromThread) override;
  void visitSums(SumVisitor& visitor) override;
  void finish() override;
  void reopen() override;
  double fullness() const override;
  double fullnessAtMost() const override;

 private:
  SkyTallyFilm(SkyTallyFilm& whole, std::vector<std::unique_ptr<Film>> films);

  SkyTally& tally_;
  std::vector<std::size_t> filmOf_;           // by population
  std::vector<std::unique_ptr<Film>> films_;  // by symmetry
  InterceptedLight intercepted_;
};

}  // namespace parhelion
