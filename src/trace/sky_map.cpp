// SPDX-License-Identifier: Apache-2.0
#include "trace/sky_map.h"

#include <algorithm>
#include <cmath>

#include "math/rotation.h"

namespace parhelion {

SkyMap::SkyMap(const Vec3& toSun, int binsPerHalfTurn)
    : toSun_(toSun), binsPerHalfTurn_(binsPerHalfTurn), bins_(columns() * rows()) {}

int SkyMap::binAt(const Vec3& toSky) const {
  const SkyPoint sky = skyPoint(toSky);
  const double perRadian = binsPerHalfTurn_ / kPi;
  const int column = static_cast<int>(std::floor(sky.azimuth * perRadian + 0.5)) + binsPerHalfTurn_;
  const int row = static_cast<int>(std::floor(sky.elevation * perRadian + 0.5)) + binsPerHalfTurn_ / 2;
  return std::clamp(row, 0, rows() - 1) * columns() + column % columns();
}

int SkyMap::add(const TracedRays& traced) {
  const auto& [queue, exits, members, population, mesh, steps] = traced;
  byBundle_.sort(queue, exits.ray, exits.count);
  for (int place = 0; place < queue.count; ++place) {
    deposits_.clear();
    for (int i = byBundle_.begin(place); i < byBundle_.begin(place + 1); ++i) {
      const int exit = byBundle_.item(i);
      const double light = queue.light[static_cast<int>(exits.ray[exit])].light;
      const Vec3 toSky = exits.undeviated[exit] != 0.0 ? toSun_ : -exits.lightDir(exit);
      deposits_.add(binAt(toSky), exits.energy[exit] * light);
    }
    for (int member = 0; member < members; ++member)
      intercepted_.add(queue.weight[place] * queue.light[queue.ray(member, place)].light);
    bins_.add(deposits_);
    ++bundles_;
  }
  return exits.count;
}

std::unique_ptr<Film> SkyMap::forThread() { return std::make_unique<SkyMap>(empty()); }

void SkyMap::merge(Film& fromThread) {
  auto& other = dynamic_cast<SkyMap&>(fromThread);
  bins_.merge(other.bins_);
  bundles_ += other.bundles_;
  intercepted_.merge(other.intercepted_);
  other = empty();
}

NamedTotals SkyMap::totals() const {
  return {{"bundles", static_cast<ExactSum::Units>(bundles_)}, {"intercepted", intercepted_.units()}};
}

void SkyMap::setTotals(const NamedTotals& totals) {
  bundles_ = static_cast<std::uint64_t>(totals.at("bundles"));
  intercepted_ = ExactSum(totals.at("intercepted"));
}

double SkyMap::azimuth(int column) const { return (column - binsPerHalfTurn_) * (kPi / binsPerHalfTurn_); }

double SkyMap::elevation(int row) const { return (row - binsPerHalfTurn_ / 2) * (kPi / binsPerHalfTurn_); }

double SkyMap::energy(int column, int row) const {
  return bundles_ > 0 ? bins_.light(row * columns() + column) / intercepted_.value() : 0.0;
}

double SkyMap::error(int column, int row) const {
  return bins_.shareError(row * columns() + column, bundles_, intercepted_.value());
}

void SkyMap::visitSums(SumVisitor& visitor) {
  bins_.visitSums(visitor);
  visitor.visit(bundles_);
  visitor.visit(intercepted_);
}

}  // namespace parhelion
