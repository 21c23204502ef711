// SPDX-License-Identifier: Apache-2.0
#include "beam/light_table.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "math/portable.h"
#include "parallel/loops.h"

namespace parhelion {

namespace {

/// The row before a place, and how far on the way to the next.
struct Between {
  std::size_t row;
  double t;
};

Between between(double place, int rows) {
  const double row = std::clamp(std::floor(place), 0.0, rows - 1.0);
  return {static_cast<std::size_t>(row), std::clamp(place - row, 0.0, 1.0)};
}

}  // namespace

LightTable::LightTable(std::vector<PrismShare> prisms, std::vector<double> indices, int columns, int rows,
                       double cutShare, const WantedPaths* wanted)
    : of_{PrismSection(), std::move(prisms), std::move(indices), cutShare, wanted},
      columns_(columns),
      rows_(rows),
      room_((columns + 1 + 3) / 4 * 4),
      table_(static_cast<std::size_t>(rows) + 1) {
  for (int column = 0; column < room_; ++column) {
    const auto [sin, cos] = portable::sincos(azimuthAt(std::min(column, columns_)));
    sines_.push_back(sin);
    cosines_.push_back(cos);
  }
}

double LightTable::meanOf(const std::vector<double>& columns) const {
  double sum = 0.0;
  for (int column = 0; column <= columns_; ++column)
    sum += (column % columns_ ? 1.0 : 0.5) * columns[static_cast<std::size_t>(column)];
  return sum / columns_;
}

void LightTable::prepare(double zeta0, double zeta1) {
  // With a stride of 2 the row before a place is up to one more away, and rounding may take it to the next.
  const auto first = std::max<std::size_t>(between(placeOf(zeta0), rows_).row, 2) - 2,
             last = std::min(between(placeOf(zeta1), rows_).row + 3, table_.size() - 1);
  std::vector<int> missing;
  for (std::size_t row = first; row <= last; ++row)
    if (!table_[row].isTraced()) missing.push_back(static_cast<int>(row));
  if (missing.empty()) return;
  forEach(missing.size(), [&](std::size_t k) { table_[static_cast<std::size_t>(missing[k])] = traced(missing[k]); });
  directions_ += static_cast<long>(missing.size() * of_.indices.size() * of_.prisms.size()) * (columns_ + 1);
  classes_ = classesOf(table_);
  if (!of_.wanted) return;
  double met = 0.0, intercepted = 0.0;
  for (const LightRow& row : table_) {
    met += row.met() / (columns_ + 1);
    intercepted += row.intercepted();
  }
  wantedShare_ = std::min(1.0, met / intercepted);
}

LightRow LightTable::traced(int row) const {
  const double zeta = 0.5 * kPi * row / rows_;
  std::vector<RowDirection> directions;
  for (int column = 0; column <= columns_; ++column)
    directions.push_back({azimuthAt(column), zeta, kPi / 12.0, (column % columns_ ? 1.0 : 0.5) / columns_});
  return {of_, directions, static_cast<std::size_t>(room_)};
}

std::vector<int> LightTable::classesIn(int row) const {
  const auto first = static_cast<std::size_t>(row / 2 * 2);
  return classesOf(std::span(table_).subspan(first, std::min<std::size_t>(3, table_.size() - first)));
}

std::vector<double> LightTable::partsOf(double index) const {
  // Lagrange's polynomial through all of them: at an index of the table it is that index alone.
  const std::vector<double>& indices = of_.indices;
  std::vector<double> parts(indices.size(), 1.0);
  for (std::size_t a = 0; a < parts.size(); ++a)
    for (std::size_t b = 0; b < parts.size(); ++b)
      if (b != a) parts[a] *= (index - indices[b]) / (indices[a] - indices[b]);
  return parts;
}

PARHELION_ALSO_AVX2 bool LightTable::lightAt(double zeta, int number, const std::vector<double>& parts, int stride,
                                             double* light) const {
  const auto [step, t] = between(placeOf(zeta) / stride, rows_ / stride);
  bool any = false;
  const auto row = step * static_cast<std::size_t>(stride);
  for (const std::size_t side : {row, row + static_cast<std::size_t>(stride)}) {
    const LightRow& from = table_[side];
    assert(from.isTraced());
    const double weight = side == row ? 1.0 - t : t;
    if (!from.has(number) || weight == 0.0) continue;
    if (!any) std::fill_n(light, room_, 0.0);
    any = true;
    from.addTo(number, parts, weight, light);
  }
  return any;
}

LightRow::Totals LightTable::totalsAt(double zeta, const std::vector<double>& parts) const {
  const auto [row, t] = between(placeOf(zeta), rows_);
  const LightRow::Totals a = table_[row].totals(parts), b = table_[row + 1].totals(parts);
  return {a.intercepted + t * (b.intercepted - a.intercepted), a.cutOff + t * (b.cutOff - a.cutOff)};
}

}  // namespace parhelion
