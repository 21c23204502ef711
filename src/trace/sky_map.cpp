// SPDX-License-Identifier: Apache-2.0
#include "trace/sky_map.h"

#include <algorithm>
#include <cmath>

#include "math/rotation.h"

namespace parhelion {

const std::array<std::string, 1> SkyMap::kTotals{kInterceptedName};

SkyMap::SkyMap(const Vec3& toSun, int binsPerHalfTurn)
    : MeasuringFilm(2 * binsPerHalfTurn * (binsPerHalfTurn + 1), kTotals),
      toSun_(toSun),
      binsPerHalfTurn_(binsPerHalfTurn) {}

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
      total(kIntercepted).add(queue.weight[place] * queue.light[queue.ray(member, place)].light);
    addBundle(deposits_, members);
  }
  return exits.count;
}

std::unique_ptr<Film> SkyMap::forThread() { return std::make_unique<SkyMap>(toSun_, binsPerHalfTurn_); }

double SkyMap::azimuth(int column) const { return (column - binsPerHalfTurn_) * (kPi / binsPerHalfTurn_); }

double SkyMap::elevation(int row) const { return (row - binsPerHalfTurn_ / 2) * (kPi / binsPerHalfTurn_); }

double SkyMap::energy(int column, int row) const {
  return bundles() > 0 ? sums().light(row * columns() + column) / valueOf(kIntercepted) : 0.0;
}

double SkyMap::error(int column, int row) const {
  return sums().shareError(row * columns() + column, bundles(), valueOf(kIntercepted));
}

}  // namespace parhelion
