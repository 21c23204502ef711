// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "math/sobol.h"
#include "trace/cloud.h"
#include "trace/drawn_crystal.h"
#include "trace/incident_ray.h"
#include "trace/lane_steps.h"

namespace parhelion {

/// Draws the rays of a run, many bundles at a time. Each ray is a pure function of the cloud, the settings and its
/// index.
///
/// Rays are distributed like the light that the crystals intercept: a crystal gets rays in proportion to its projected
/// area in its own orientation. For one thread.
class RaySource {
 public:
  /// Draws at most `room` bundles at a time. `cloud` must outlive the source.
  RaySource(const Cloud& cloud, const TraceSettings& settings, int room,
            const LaneSteps& steps = parhelion::laneSteps());

  /// Draws bundles first ... first + count - 1, each into the queue of its population. They replace what was drawn
  /// before. Where shapes are spread, all must be of one block of Cloud::bundlesPerShape() bundles.
  void draw(std::uint64_t first, int count);

  /// One queue for each population, in the cloud's order.
  std::vector<RayQueue>& queues() { return queues_; }

  /// The crystal that the bundles drawn meet in a population: as a mesh, and for lanes.
  const CrystalMesh& mesh(int population) const;
  const FaceTable& faces(int population) const;

  /// The number of its block; none where all crystals of the population are alike.
  std::optional<std::uint64_t> blockOf(int population) const {
    return drawn_[population] ? std::optional(drawn_[population]->block) : std::nullopt;
  }

  /// Ray `index` of the run, by itself. Where its population's shape is spread, the crystal is valid until another is
  /// asked for.
  IncidentRay ray(std::uint64_t index);

 private:
  struct Place {
    int population, place;
  };
  void drawCrystals(std::uint64_t block);
  void propose(int population, int attempt);
  /// A bundle has one Sobol' point; further attempts, which only crystals that are not convex need, are independent.
  bool drawsSobol(int attempt) const { return !sobol_.empty() && attempt == 0; }
  void fill(const std::uint64_t* bundles, int count, int attempt);
  void fillSobol(const std::uint64_t* bundles, int count, int dimension, double* numbers);
  void splitByPopulation(int attempt);
  void setLight(RayQueue& queue);

  const Cloud& cloud_;
  const LaneSteps& steps_;
  std::uint64_t seed_;
  Sampler sampler_;
  std::vector<SobolPoints> sobol_;  // for bundles of even and of odd number; empty for independent numbers
  int room_;

  std::vector<RayQueue> queues_;
  std::vector<std::optional<DrawnCrystal>> drawn_;  // by population, where shapes are spread
  IncidenceNumbers numbers_{};
  std::vector<std::uint64_t> waiting_;                  // bundles that have no ray yet
  std::vector<std::vector<std::uint64_t>> candidates_;  // the same, by the population that each tries next
  std::uint64_t first_ = 0;                             // the first of the bundles drawn
  std::vector<Place> places_;                           // where each of the bundles drawn is, in their order
};

}  // namespace parhelion
