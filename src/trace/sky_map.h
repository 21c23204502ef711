// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>

#include "trace/bundle_bins.h"
#include "trace/measuring_film.h"
#include "trace/traced_rays.h"

namespace parhelion {

/// Light over a grid of azimuth and elevation that covers the whole sphere. Bins are centred on multiples of the step:
/// azimuth from -180 degrees up to below 180, elevation from -90 to 90, the rows at the poles being half as high.
/// The undeviated light is in the bin of the sun's centre.
class SkyMap : public MeasuringFilm {
 public:
  /// `binsPerHalfTurn` columns make 180 degrees: 180 for steps of one degree.
  SkyMap(const Vec3& toSun, int binsPerHalfTurn);

  int add(const TracedRays& traced) override;
  std::unique_ptr<Film> forThread() override;

  int binsPerHalfTurn() const { return binsPerHalfTurn_; }
  int columns() const { return 2 * binsPerHalfTurn_; }
  int rows() const { return binsPerHalfTurn_ + 1; }
  double azimuth(int column) const;  // rad, of a column's centre
  double elevation(int row) const;   // rad, of a row's centre

  /// Share of all intercepted light in a bin, and its standard error (BundleBins::shareError()).
  double energy(int column, int row) const;
  double error(int column, int row) const;

 private:
  static const std::array<std::string, 1> kTotals;
  int binAt(const Vec3& toSky) const;

  Vec3 toSun_;
  int binsPerHalfTurn_;
  BundleDeposits<double> deposits_;
  ByBundle byBundle_;
};

}  // namespace parhelion
