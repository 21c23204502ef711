// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "math/conventions.h"

namespace parhelion {

/// Bins of azimuth and elevation that cover the whole sphere. They are centred on multiples of the step: azimuth from
/// -180 degrees up to below 180, elevation from -90 to 90, the rows at the poles being half as high.
class MapGrid {
 public:
  /// `binsPerHalfTurn` columns make 180 degrees: 180 for steps of one degree. An even number.
  explicit MapGrid(int binsPerHalfTurn) : binsPerHalfTurn_(binsPerHalfTurn) {}

  int binsPerHalfTurn() const { return binsPerHalfTurn_; }
  int columns() const { return 2 * binsPerHalfTurn_; }
  int rows() const { return binsPerHalfTurn_ + 1; }
  int bins() const { return rows() * columns(); }
  double azimuth(int column) const;  // rad, of a column's centre
  double elevation(int row) const;   // rad, of a row's centre

  int bin(int column, int row) const { return row * columns() + column; }

  /// The bin of a unit world vector.
  int binAt(const Vec3& toSky) const;

 private:
  int binsPerHalfTurn_;
};

/// Light over the sphere, by bin: the share of all intercepted light, and its standard error.
struct LightMap {
  MapGrid grid;
  std::vector<double> energy, error;

  explicit LightMap(const MapGrid& bins)
      : grid(bins), energy(static_cast<std::size_t>(bins.bins())), error(static_cast<std::size_t>(bins.bins())) {}
};

}  // namespace parhelion
