// SPDX-License-Identifier: Apache-2.0
#include "trace/radial_film.h"

namespace parhelion {

int RadialFilm::add(const TracedRays& traced) {
  const auto& [queue, exits, members, population, mesh, steps] = traced;
  intercepted_.add(traced);
  byBundle_.sort(queue, exits.ray, exits.count);
  int seen = 0;
  for (int place = 0; place < queue.count; ++place) {
    deposits_.clear();
    for (int i = byBundle_.begin(place); i < byBundle_.begin(place + 1); ++i) {
      const int exit = byBundle_.item(i);
      if (exits.undeviated[exit] != 0.0) continue;
      const Vec3& xyz = queue.light[static_cast<int>(exits.ray[exit])].xyz;
      deposits_.add(sky_.binAt(-exits.lightDir(exit)), exits.energy[exit] * xyz);
      ++seen;
    }
    const bool firstHalf = queue.bundle[place] % 2 == 0;
    for (const auto& [ring, xyz] : deposits_.all()) sky_.add(ring, xyz, firstHalf);
  }
  return seen;
}

void RadialFilm::merge(Film& fromThread) {
  auto& other = dynamic_cast<RadialFilm&>(fromThread);
  sky_.merge(other.sky_);
  other.sky_.clear();
  other.intercepted_.moveTo(tally_.info);
}

void RadialFilm::visitSums(SumVisitor& visitor) {
  visitor.visit(sky_.sums());
  tally_.info.visitTotals(visitor);
}

}  // namespace parhelion
