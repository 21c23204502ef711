// SPDX-License-Identifier: Apache-2.0
#include "beam/light_table.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "beam/wanted_tracer.h"
#include "math/portable.h"
#include "parallel/loops.h"

namespace parhelion {

namespace {

// Classes with less than this share of a row's light are left out.
constexpr double kFaintest = 1e-9;

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
    : prisms_(std::move(prisms)),
      indices_(std::move(indices)),
      columns_(columns),
      rows_(rows),
      room_((columns + 1 + 3) / 4 * 4),
      cutShare_(cutShare),
      wanted_(wanted),
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
  const auto first = std::max<std::size_t>(between(placeOf(zeta0), rows_).row, 1) - 1,
             last = std::min(between(placeOf(zeta1), rows_).row + 2, table_.size() - 1);
  std::vector<int> missing;
  for (std::size_t row = first; row <= last; ++row)
    if (!table_[row].traced) missing.push_back(static_cast<int>(row));
  if (missing.empty()) return;
  forEach(missing.size(), [&](std::size_t k) { table_[static_cast<std::size_t>(missing[k])] = traced(missing[k]); });
  directions_ += static_cast<long>(missing.size() * indices_.size() * prisms_.size()) * (columns_ + 1);
  classes_ = classesOf(table_);
  if (!wanted_) return;
  double met = 0.0, intercepted = 0.0;
  for (const Row& row : table_) {
    met += row.met / (columns_ + 1);
    for (const Totals& totals : row.totals) intercepted += totals.intercepted;
  }
  wantedShare_ = std::min(1.0, met / intercepted);
}

LightTable::Row LightTable::traced(int row) const {
  const double zeta = 0.5 * kPi * row / rows_;
  const std::size_t indices = indices_.size(), room = static_cast<std::size_t>(room_);
  Row result;
  result.traced = true;
  result.slot.assign(kLightClasses, -1);
  result.totals.resize(indices);
  PrismLight light;
  for (const PrismShare& prism : prisms_) {
    const double share = prism.share / section_.surface(prism.length);
    for (std::size_t n = 0; n < indices; ++n) {
      WantedTracer tracer(section_, prism.length, indices_[n], cutShare_, false, wanted_);
      for (int column = 0; column <= columns_; ++column) {
        traceAt(tracer, azimuthAt(column), zeta, kPi / 12.0, light);
        const double mean = share * (column % columns_ ? 1.0 : 0.5) / columns_;
        for (std::size_t e = 0; e < kPrismFaces; ++e) {
          result.totals[n].intercepted += mean * light.shadow[e];
          result.totals[n].cutOff += mean * light.shadow[e] * (1.0 - light.reflectance[e]) * light.cutOff[e];
        }
        forEachClass(light, [&](int number, double met) {
          short& slot = result.slot[static_cast<std::size_t>(number)];
          if (slot < 0) {
            slot = static_cast<short>(result.light.size() / (indices * room));
            result.light.resize(result.light.size() + indices * room);
          }
          result.light[(static_cast<std::size_t>(slot) * indices + n) * room + static_cast<std::size_t>(column)] +=
              static_cast<float>(share * met);
        });
      }
    }
  }
  findClasses(result);
  return result;
}

void LightTable::findClasses(Row& row) const {
  std::vector<double> light(kLightClasses, 0.0);
  double& all = row.met;
  const std::size_t size = indices_.size() * static_cast<std::size_t>(room_);
  for (std::size_t number = 0; number < light.size(); ++number) {
    if (row.slot[number] < 0) continue;
    const float* from = row.light.data() + static_cast<std::size_t>(row.slot[number]) * size;
    for (std::size_t k = 0; k < size; ++k) light[number] += static_cast<double>(from[k]);
    all += light[number];
  }
  for (std::size_t number = 0; number < light.size(); ++number)
    if (light[number] > kFaintest * all) row.classes.push_back(static_cast<int>(number));
}

std::vector<int> LightTable::classesIn(int row) const {
  const auto first = static_cast<std::size_t>(row / 2 * 2);
  return classesOf(std::span(table_).subspan(first, std::min<std::size_t>(3, table_.size() - first)));
}

std::vector<int> LightTable::classesOf(std::span<const Row> rows) {
  std::vector<int> all;
  for (const Row& row : rows) all.insert(all.end(), row.classes.begin(), row.classes.end());
  std::ranges::sort(all);
  all.erase(std::ranges::unique(all).begin(), all.end());
  return all;
}

std::vector<double> LightTable::partsOf(double index) const {
  // Lagrange's polynomial through all of them: at an index of the table it is that index alone.
  std::vector<double> parts(indices_.size(), 1.0);
  for (std::size_t a = 0; a < parts.size(); ++a)
    for (std::size_t b = 0; b < parts.size(); ++b)
      if (b != a) parts[a] *= (index - indices_[b]) / (indices_[a] - indices_[b]);
  return parts;
}

PARHELION_ALSO_AVX2 bool LightTable::lightAt(double zeta, int number, const std::vector<double>& parts, int stride,
                                             double* light) const {
  const auto [step, t] = between(placeOf(zeta) / stride, rows_ / stride);
  const std::size_t indices = indices_.size(), room = static_cast<std::size_t>(room_);
  bool any = false;
  const auto row = step * static_cast<std::size_t>(stride);
  for (const std::size_t side : {row, row + static_cast<std::size_t>(stride)}) {
    const Row& from = table_[side];
    const short slot = from.slot[static_cast<std::size_t>(number)];
    const double weight = side == row ? 1.0 - t : t;
    if (slot < 0 || weight == 0.0) continue;
    if (!any) std::fill_n(light, room, 0.0);
    any = true;
    for (std::size_t n = 0; n < indices; ++n) {
      const double part = weight * parts[n];
      if (part == 0.0) continue;
      const float* met = from.light.data() + (static_cast<std::size_t>(slot) * indices + n) * room;
      for (std::size_t k = 0; k < room; ++k) light[k] += part * static_cast<double>(met[k]);
    }
  }
  return any;
}

LightTable::Totals LightTable::totalsAt(double zeta, const std::vector<double>& parts) const {
  const auto [row, t] = between(placeOf(zeta), rows_);
  Totals sum;
  for (std::size_t n = 0; n < parts.size(); ++n) {
    const Totals &a = table_[row].totals[n], &b = table_[row + 1].totals[n];
    sum.intercepted += parts[n] * (a.intercepted + t * (b.intercepted - a.intercepted));
    sum.cutOff += parts[n] * (a.cutOff + t * (b.cutOff - a.cutOff));
  }
  return sum;
}

}  // namespace parhelion
