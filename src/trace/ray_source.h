// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "math/sobol.h"
#include "trace/cloud.h"
#include "trace/incident_ray.h"
#include "trace/lane_steps.h"

namespace parhelion {

/// Draws the rays of a run, many bundles at a time. Each is a pure function of the cloud, the settings and its index;
/// rays are distributed like the light that the crystals intercept: each crystal in proportion to its projected area in
/// its own orientation. For one thread.
class RaySource {
 public:
  /// Draws at most `room` bundles at a time. `cloud` must outlive the source.
  RaySource(const Cloud& cloud, const TraceSettings& settings, int room,
            const LaneSteps& steps = parhelion::laneSteps());

  /// Draws bundles first ... first + count - 1 in place of what was drawn before, each into the queue of its
  /// population.
  void draw(std::uint64_t first, int count);

  /// One a population, in the cloud's order.
  std::vector<RayQueue>& queues() { return queues_; }

  /// Ray `index` of the run alone.
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
  std::vector<SobolPoints> sobol_;  // of the bundles of even and of odd number; none for independent numbers
  int room_;

  std::vector<RayQueue> queues_;
  IncidenceNumbers numbers_{};
  std::vector<std::uint64_t> waiting_;                  // bundles that have no ray yet
  std::vector<std::vector<std::uint64_t>> candidates_;  // of them, by the population to be tried next
  std::uint64_t first_ = 0;                             // of the bundles drawn
  std::vector<Place> places_;                           // of the bundles drawn, in their order
};

}  // namespace parhelion
