// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "sky/tally.h"
#include "trace/film.h"
#include "trace/layered_deposits.h"

namespace parhelion {

/// Exposes rings about the sun's centre, for crystals in random orientation: every ray counts for whole rings of the
/// sky. There are rings for each layer. Undeviated light is in no ring. Totals of light are not kept here
/// (trace/intercepted_light.h).
class RadialFilm : public Film {
 public:
  /// The tallies must outlive the film and stay where they are. The sun's centre is toward `toSun` (unit, world).
  /// `shared` is SkyTally::Shared, null for a single layer.
  RadialFilm(std::vector<Tally*> layers, Tally* shared, const Vec3& toSun);

  int add(const TracedRays& traced) override;
  std::unique_ptr<Film> forThread() override { return std::unique_ptr<RadialFilm>(new RadialFilm(*this, ForThread{})); }
  void merge(Film& fromThread) override;
  void visitSums(SumVisitor& visitor) override;

  /// Spreads the rings over the tallies' pixels, in the place of what was there.
  void finish() override;
  double fullness() const override;
  double fullnessAtMost() const override;

 private:
  struct ForThread {};
  /// A thread has rings of its own.
  RadialFilm(const RadialFilm& whole, ForThread);

  /// Of layers, and shared ones if there are some.
  std::vector<RadialSky*> all() const;

  std::vector<Tally*> layers_;
  Tally* shared_;
  std::vector<std::unique_ptr<RadialSky>> own_;  // none: the rings are the tallies'
  std::vector<RadialSky*> skies_;                // by layer
  RadialSky* sharedSky_ = nullptr;
  LayeredDeposits deposits_;
  ByBundle byBundle_;
};

}  // namespace parhelion
