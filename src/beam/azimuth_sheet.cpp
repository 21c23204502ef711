// SPDX-License-Identifier: Apache-2.0
#include "beam/azimuth_sheet.h"

#include <algorithm>
#include <cmath>

#include "math/portable.h"

namespace parhelion {

namespace {

/// A direction of a crystal's frame in the world, by the sine and cosine of the crystal's azimuth.
template <class T>
PARHELION_INLINE Triple<T> turned(const RotationColumns<double>& rest, const Triple<T>& v, const T& sin, const T& cos) {
  const T x = rest.x.x * v.x + rest.y.x * v.y + rest.z.x * v.z, y = rest.x.y * v.x + rest.y.y * v.y + rest.z.y * v.z,
          z = rest.x.z * v.x + rest.y.z * v.y + rest.z.z * v.z;
  return {cos * x - sin * y, sin * x + cos * y, z};
}

}  // namespace

AzimuthSheet::AzimuthSheet(const AzimuthLight& light, const Lens& lens, const SheetPicture& picture)
    : light_(light), lens_(lens), cells_(lens, picture) {}

SheetTotals AzimuthSheet::add(const AzimuthStrip& strip, PixelFilm& film) {
  strip_ = strip;
  const std::size_t rows = strip.rows.size();
  if (rows_.size() < rows) {
    constexpr std::size_t kRoom = AzimuthLight::kRoom;
    const std::vector<double> room(kRoom);
    rows_.resize(rows, {SheetNodes(kRoom), room, room, room, room, room, {}});
  }
  const auto ruleOf = [&](std::size_t row) {
    if (rows == 1) return 1.0;
    return (row == 0 || row + 1 == rows ? 0.5 : 1.0) / static_cast<double>(rows - 1);
  };
  for (std::size_t row = 0; row < rows; ++row) rows_[row].parts = light_.partsOf(strip.rows[row].index);
  SheetTotals totals;
  for (piece_ = light_.first(); piece_ < light_.last(); ++piece_) {
    for (std::size_t row = 0; row < rows; ++row) {
      place(rows_[row], strip.rows[row]);
      const LightRow::Totals own = light_.piece(strip.rows[row].elevation, piece_).totals(rows_[row].parts);
      const double share = ruleOf(row) * strip.rows[row].weight;
      totals.intercepted += share * own.intercepted;
      totals.cutOff += share * own.cutOff;
    }
    for (const int number : light_.classesIn(piece_)) {
      class_ = number;
      for (std::size_t row = 0; row < rows; ++row) see(rows_[row], strip.rows[row]);
      if (!LightClass(number).isUndeviated()) {
        addClass(film);
        continue;
      }
      for (std::size_t row = 0; row < rows; ++row) {
        if (rows_[row].nodes.dark) continue;
        const std::vector<double>& density = rows_[row].nodes.density;
        double sum = 0.5 * (density[0] + density[AzimuthLight::kPiece]);
        for (std::size_t k = 1; k < AzimuthLight::kPiece; ++k) sum += density[k];
        totals.undeviated += ruleOf(row) * sum / light_.columns();
      }
    }
  }
  return totals;
}

void AzimuthSheet::place(Row& row, const AzimuthRow& at) {
  for (std::size_t k = 0; k < AzimuthLight::kRoom; ++k) {
    const double azimuth = light_.azimuthAt(piece_ * AzimuthLight::kPiece + static_cast<double>(k));
    const Triple<double> dir = light_.lightDirAt(light_.elevation(at.elevation), azimuth);
    row.x[k] = dir.x;
    row.y[k] = dir.y;
    row.z[k] = dir.z;
    const auto [sin, cos] = portable::sincos(azimuth + at.azimuth);
    row.sin[k] = sin;
    row.cos[k] = cos;
  }
}

PARHELION_ALSO_AVX2 void AzimuthSheet::see(Row& row, const AzimuthRow& at) const {
  SheetNodes& nodes = row.nodes;
  const LightRow& light = light_.piece(at.elevation, piece_);
  nodes.dark = !light.has(class_);
  if (nodes.dark) return;
  std::fill(nodes.light.begin(), nodes.light.end(), 0.0);
  light.addTo(class_, row.parts, at.weight, nodes.light.data());
  const LightClass of(class_);
  const RelativeIndexOf<Four> index(all<Four>(at.index));
  for (std::size_t k = 0; k < AzimuthLight::kRoom; k += 4) {
    const Four met = higher(load<Four>(&nodes.light[k]), Four{});
    const ClassExit<Four> exit =
        of.exit(Triple<Four>{load<Four>(&row.x[k]), load<Four>(&row.y[k]), load<Four>(&row.z[k])}, index);
    store(&nodes.light[k], met);
    store(&nodes.density[k], Four(met * exit.transmittance));
    store(&nodes.excess[k], exit.excess);
    const Triple<Four> toSky =
        -turned<Four>(light_.rest(), exit.lightDir, load<Four>(&row.sin[k]), load<Four>(&row.cos[k]));
    const PicturePlace<Four> place = lens_.placeBeyond(toSky);
    store(&nodes.x[0][k], place.x);
    store(&nodes.y[0][k], place.y);
    store(&nodes.seen[0][k], select(place.inside, all<Four>(1.0), Four{}));
  }
}

void AzimuthSheet::addClass(PixelFilm& film) {
  const std::size_t rows = strip_.rows.size();
  if (rows == 1) {
    addLine(1, film);
    if (strip_.coarse > 0.0) addLine(2, film);
    return;
  }
  for (std::size_t row = 0; row + 1 < rows; ++row) {
    addBetween(row, 1, film);
    if (strip_.coarse > 0.0 && row % 2 == 0) addBetween(row, 2, film);
  }
}

void AzimuthSheet::addBetween(std::size_t first, std::size_t step, PixelFilm& film) const {
  const Tristimulus& xyz = strip_.xyz[first];
  const Four per =
      step == 1 ? Four{xyz[0], xyz[1], xyz[2], 0.0} : Four{0.0, 0.0, 0.0, 0.5 * (xyz[1] + strip_.xyz[first + 1][1])};
  const double size = static_cast<double>(step), cells = static_cast<double>(strip_.rows.size() - 1);
  const double share = (step == 1 ? strip_.share : strip_.coarse) * size * size / cells / light_.columns();
  cells_.addCells(
      rows_[first].nodes, rows_[first + step].nodes, {0, AzimuthLight::kPiece, static_cast<int>(step), share, per},
      film, [&](bool behind, int column) { return cornerOf(behind ? first + step : first, column); },
      [&](const SheetCorner& corner) { return exitAt(corner); });
}

void AzimuthSheet::addLine(int step, PixelFilm& film) const {
  const Tristimulus& xyz = strip_.xyz[0];
  const Four per = step == 1 ? Four{xyz[0], xyz[1], xyz[2], 0.0} : Four{0.0, 0.0, 0.0, xyz[1]};
  cells_.addLines(
      rows_[0].nodes,
      {0, AzimuthLight::kPiece, step, (step == 1 ? strip_.share : strip_.coarse) * step / light_.columns(), per}, film,
      [&](int column) { return cornerOf(0, column); }, [&](const SheetCorner& corner) { return exitAt(corner); });
}

SheetCorner AzimuthSheet::cornerOf(std::size_t row, int column) const {
  const SheetNodes& nodes = rows_[row].nodes;
  const double light = nodes.dark ? 0.0 : nodes.light[static_cast<std::size_t>(column)];
  return exitAt({static_cast<double>(row), static_cast<double>(column), light, 0.0, 0.0, {}});
}

SheetCorner AzimuthSheet::exitAt(SheetCorner corner) const {
  // All is linear between rows.
  const auto first = std::min(static_cast<std::size_t>(corner.row), strip_.rows.size() - 1),
             next = std::min(first + 1, strip_.rows.size() - 1);
  const double t = corner.row - static_cast<double>(first);
  const auto mix = [t](double a, double b) { return a + t * (b - a); };
  const AzimuthRow &a = strip_.rows[first], &b = strip_.rows[next];
  const double azimuth = light_.azimuthAt(piece_ * AzimuthLight::kPiece + corner.column);
  const Triple<double> dir =
      light_.lightDirAt(mix(light_.elevation(a.elevation), light_.elevation(b.elevation)), azimuth);
  const ClassExit<double> exit = LightClass(class_).exit(dir, RelativeIndexOf<double>(mix(a.index, b.index)));
  const auto [sin, cos] = portable::sincos(azimuth + mix(a.azimuth, b.azimuth));
  corner.density = corner.light * exit.transmittance;
  corner.excess = exit.excess;
  corner.lightDir = turned(light_.rest(), exit.lightDir, sin, cos);
  return corner;
}

}  // namespace parhelion
