// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "math/sobol.h"
#include "trace/cloud.h"
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
  /// before.
  void draw(std::uint64_t first, int count);

  /// One queue for each population, in the cloud's order.
  std::vector<RayQueue>& queues() { return queues_; }

  /// Ray `index` of the run, by itself.
  IncidentRay ray(std::uint64_t index);

 private:
  struct Place {
    int population, place;
  };
  void propose(int population, int attempt);
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
  IncidenceNumbers numbers_{};
  std::vector<std::uint64_t> waiting_;                  // bundles that have no ray yet
  std::vector<std::vector<std::uint64_t>> candidates_;  // the same, by the population that each tries next
  std::uint64_t first_ = 0;                             // the first of the bundles drawn
  std::vector<Place> places_;                           // where each of the bundles drawn is, in their order
};

}  // namespace parhelion
