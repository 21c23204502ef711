// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>

#include "sky/light_map.h"
#include "trace/bundle_bins.h"
#include "trace/measuring_film.h"
#include "trace/traced_rays.h"

namespace parhelion {

/// Light over the whole sphere, in the bins of a MapGrid. The undeviated light is in the bin of the sun's centre.
class SkyMap : public MeasuringFilm {
 public:
  SkyMap(const Vec3& toSun, int binsPerHalfTurn);

  int add(const TracedRays& traced) override;
  std::unique_ptr<Film> forThread() override;

  int binsPerHalfTurn() const { return grid_.binsPerHalfTurn(); }
  int columns() const { return grid_.columns(); }
  int rows() const { return grid_.rows(); }
  double azimuth(int column) const { return grid_.azimuth(column); }
  double elevation(int row) const { return grid_.elevation(row); }

  /// Share of all intercepted light in a bin, and its standard error (BundleBins::shareError()).
  double energy(int column, int row) const;
  double error(int column, int row) const;

  /// The same of all bins.
  LightMap light() const;

 private:
  static const std::array<std::string, 1> kTotals;

  Vec3 toSun_;
  MapGrid grid_;
  BundleDeposits<double> deposits_;
  ByBundle byBundle_;
};

}  // namespace parhelion
