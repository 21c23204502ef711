// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "math/exact_sum.h"
#include "trace/bundle_bins.h"
#include "trace/film.h"
#include "trace/named_totals.h"

namespace parhelion {

/// Light over a grid of azimuth and elevation that covers the whole sphere. Bins are centred on multiples of the step:
/// azimuth from -180 degrees up to below 180, elevation from -90 to 90, the rows at the poles being half as high.
/// The undeviated light is in the bin of the sun's centre.
class SkyMap : public Film {
 public:
  /// `binsPerHalfTurn` columns make 180 degrees: 180 for steps of one degree.
  SkyMap(const Vec3& toSun, int binsPerHalfTurn);

  int add(const TracedRays& traced) override;
  std::unique_ptr<Film> forThread() override;
  void merge(Film& fromThread) override;
  void visitSums(SumVisitor& visitor) override;
  double fullness() const override { return bins_.fullness(); }

  /// All that it has summed, for files and for adding maps of different rays. setTotals() takes what totals() gives:
  /// throws std::out_of_range where one is missing.
  NamedTotals totals() const;
  void setTotals(const NamedTotals& totals);
  const BundleBins& sums() const { return bins_; }
  BundleBins& sums() { return bins_; }

  int binsPerHalfTurn() const { return binsPerHalfTurn_; }
  int columns() const { return 2 * binsPerHalfTurn_; }
  int rows() const { return binsPerHalfTurn_ + 1; }
  double azimuth(int column) const;  // rad, of a column's centre
  double elevation(int row) const;   // rad, of a row's centre

  /// Share of all intercepted light in a bin, and its standard error (BundleBins::shareError()).
  double energy(int column, int row) const;
  double error(int column, int row) const;

 private:
  SkyMap empty() const { return SkyMap(toSun_, binsPerHalfTurn_); }
  int binAt(const Vec3& toSky) const;

  Vec3 toSun_;
  int binsPerHalfTurn_;
  BundleBins bins_;
  BundleDeposits<double> deposits_;
  ByBundle byBundle_;
  std::uint64_t bundles_ = 0;
  ExactSum intercepted_;
};

}  // namespace parhelion
