// SPDX-License-Identifier: Apache-2.0
#include "trace/sky_map.h"

namespace parhelion {

const std::array<std::string, 1> SkyMap::kTotals{kInterceptedName};

SkyMap::SkyMap(const Vec3& toSun, int binsPerHalfTurn)
    : MeasuringFilm(MapGrid(binsPerHalfTurn).bins(), kTotals), toSun_(toSun), grid_(binsPerHalfTurn) {}

int SkyMap::add(const TracedRays& traced) {
  const auto& [queue, exits, members, population, mesh, steps] = traced;
  byBundle_.sort(queue, exits.ray, exits.count);
  for (int place = 0; place < queue.count; ++place) {
    deposits_.clear();
    for (int i = byBundle_.begin(place); i < byBundle_.begin(place + 1); ++i) {
      const int exit = byBundle_.item(i);
      const double light = queue.light[static_cast<int>(exits.ray[exit])].light;
      const Vec3 toSky = exits.undeviated[exit] != 0.0 ? toSun_ : -exits.lightDir(exit);
      deposits_.add(grid_.binAt(toSky), exits.energy[exit] * light);
    }
    for (int member = 0; member < members; ++member)
      total(kIntercepted).add(queue.weight[place] * queue.light[queue.ray(member, place)].light);
    addBundle(deposits_, members);
  }
  return exits.count;
}

std::unique_ptr<Film> SkyMap::forThread() { return std::make_unique<SkyMap>(toSun_, binsPerHalfTurn()); }

double SkyMap::energy(int column, int row) const {
  return bundles() > 0 ? sums().light(grid_.bin(column, row)) / valueOf(kIntercepted) : 0.0;
}

double SkyMap::error(int column, int row) const {
  return sums().shareError(grid_.bin(column, row), bundles(), valueOf(kIntercepted));
}

LightMap SkyMap::light() const {
  LightMap map(grid_);
  for (int row = 0; row < rows(); ++row)
    for (int column = 0; column < columns(); ++column) {
      const auto bin = static_cast<std::size_t>(grid_.bin(column, row));
      map.energy[bin] = energy(column, row);
      map.error[bin] = error(column, row);
    }
  return map;
}

}  // namespace parhelion
