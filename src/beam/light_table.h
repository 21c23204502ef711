// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <vector>

#include "beam/light_row.h"
#include "math/lanes.h"

namespace parhelion {

/// What becomes of light of all directions in regular prisms: traced at the nodes of a grid, linear between them.
///
/// Columns are azimuths in the crystal's frame from 0 to 30 degrees, and rows are angles from -c, from 0 to 90 degrees;
/// all other directions follow by the prism's symmetry. Rows are traced as they are needed.
class LightTable {
 public:
  using Four = Lanes<4>::Real;

  /// What prisms (shares of one surface) do to light of each index. `columns` and `rows`: cells along the azimuth and
  /// the angle. `cutShare` as PrismTracer has it. Without `wanted`, which must outlive this, all light is.
  LightTable(std::vector<PrismShare> prisms, std::vector<double> indices, int columns, int rows, double cutShare,
             const WantedPaths* wanted = nullptr);

  int columns() const { return columns_; }
  int rows() const { return rows_; }

  /// Numbers that a row of nodes takes, with some behind the last one.
  int room() const { return room_; }

  double azimuthAt(int column) const { return kPi / 6.0 * column / columns_; }

  /// Sines and cosines of the columns' azimuths, with room behind the last one.
  const std::vector<double>& sines() const { return sines_; }
  const std::vector<double>& cosines() const { return cosines_; }

  /// The mean over the azimuths of what the columns have.
  double meanOf(const std::vector<double>& columns) const;

  /// Where among the rows an angle from -c lies.
  double placeOf(double zeta) const { return zeta * (2.0 / kPi) * rows_; }

  /// Traces all rows that angles between these two look at and that are not traced yet, in parallel. An angle may be
  /// off by rounding.
  void prepare(double zeta0, double zeta1);

  /// Numbers of the classes (LightClass) that have light in any row that was traced.
  const std::vector<int>& classes() const { return classes_; }

  /// The same of the rows about cell `row`, as lightAt() looks at them with strides of 1 or 2.
  std::vector<int> classesIn(int row) const;

  /// A bound of how much of the light that crystals intercept is wanted, more or less; 1 where all is.
  double wantedShare() const { return wantedShare_; }

  /// How much of each index's table makes the light of another index: parts that add up to 1.
  std::vector<double> partsOf(double index) const;

  /// The light that meets a class's exit at each node of an angle, which must have been prepared; per surface, in units
  /// of mean shadows. It is linear between rows, of which only each `stride`-th is looked at. Returns false, and leaves
  /// `light` as it is, where there is none.
  bool lightAt(double zeta, int number, const std::vector<double>& parts, int stride, double* light) const;

  /// What crystals intercept at that angle, and what was cut off: the means over the azimuths.
  LightRow::Totals totalsAt(double zeta, const std::vector<double>& parts) const;

  long directions() const { return directions_; }

 private:
  LightRow traced(int row) const;

  TracedPrisms of_;
  int columns_, rows_, room_;
  std::vector<double> sines_, cosines_;
  std::vector<LightRow> table_;
  std::vector<int> classes_;
  double wantedShare_ = 1.0;
  long directions_ = 0;
};

}  // namespace parhelion
