// SPDX-License-Identifier: Apache-2.0
#include "beam/orientation_sheet.h"

#include <algorithm>
#include <cmath>

#include "beam/sun_frame.h"
#include "math/portable.h"

namespace parhelion {

namespace {

// c that moves less than this (rad) stands still; azimuths are parted no further than to this.
constexpr double kStill = 1e-7, kNarrowest = 1e-6;

Triple<double> tripleOf(const Vec3& v) { return {v.x, v.y, v.z}; }

Triple<double> cross(const Triple<double>& a, const Triple<double>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

double lengthOf(const Triple<double>& v) { return std::sqrt(dot(v, v)); }

}  // namespace

OrientationSheet::OrientationSheet(const LightTable& table, const Lens& lens, const SheetMesh& mesh)
    : table_(table), lens_(lens), mesh_(mesh), cells_(lens, mesh), views_(mesh.folds ? 2 : SheetNodes::kViews) {
  nodes_.fill(Nodes(static_cast<std::size_t>(table.room())));
}

OrientationSheet::Four OrientationSheet::perLight(int step) const {
  return step == 1 ? Four{point_.xyz[0], point_.xyz[1], point_.xyz[2], 0.0} : Four{0.0, 0.0, 0.0, point_.xyz[1]};
}

std::array<double, 2> OrientationSheet::anglesAt(double tilt, const Vec3& toSun) {
  const double zenith = portable::atan2(std::hypot(toSun.x, toSun.y), toSun.z), quarter = 0.5 * kPi;
  // Of c and -c, that which is nearer to the sun.
  const double least = std::abs(std::remainder(tilt - zenith, 2.0 * kPi)),
               most = std::abs(std::remainder(tilt + zenith, 2.0 * kPi));
  const auto folded = [&](double angle) { return angle > quarter ? kPi - angle : angle; };
  const bool across = std::min(least, most) <= quarter && std::max(least, most) >= quarter;
  return {std::min(folded(least), folded(most)), across ? quarter : std::max(folded(least), folded(most))};
}

OrientationSheet::Frame OrientationSheet::frameAt(double azimuth, bool upper) const {
  const auto [sinTilt, cosTilt] = portable::sincos(point_.tilt);
  const auto [sin, cos] = portable::sincos(azimuth);
  Frame frame;
  frame.azimuth = azimuth;
  frame.c = (sinTilt * cos) * level_ + (sinTilt * sin) * left_ + Triple<double>{0.0, 0.0, cosTilt};
  if (!upper) frame.c = -frame.c;
  const Triple<double> toSun = tripleOf(point_.toSun);
  const double onto = dot(toSun, frame.c);
  const Triple<double> across = onto * frame.c - toSun;
  frame.sinZeta = lengthOf(across);
  frame.cosZeta = std::max(onto, 0.0);
  frame.across = frame.sinZeta > 0.0 ? (1.0 / frame.sinZeta) * across : left_;
  frame.beside = cross(frame.c, frame.across);
  frame.zeta = portable::atan2(frame.sinZeta, frame.cosZeta);
  return frame;
}

std::vector<OrientationSheet::Run> OrientationSheet::runs() const {
  const auto [sinTilt, cosTilt] = portable::sincos(point_.tilt);
  const double level = std::hypot(point_.toSun.x, point_.toSun.y);
  const double swing = sinTilt * level, mean = cosTilt * point_.toSun.z;  // of the cosine between c and the sun
  if (std::abs(sinTilt) * kPi < kStill) {
    Frame only = frameAt(0.0, mean >= 0.0);
    only.weight = 1.0;
    return {{{only}, mean >= 0.0}};
  }
  // Where c passes the plane across the light, -c takes its place.
  std::vector<double> ends{0.0};
  if (std::abs(mean) < std::abs(swing)) ends.push_back(std::acos(-mean / swing));
  ends.push_back(kPi);
  std::vector<Run> all;
  for (std::size_t k = 1; k < ends.size(); ++k) {
    const double from = ends[k - 1], to = ends[k];
    if (to - from < kNarrowest) continue;
    const double half = 0.5 * (from + to);
    const bool upper = mean + swing * portable::cos(half) >= 0.0;
    const int cells = std::max(2, static_cast<int>(std::ceil((to - from) * std::abs(sinTilt) / (2.0 * mesh_.step))));
    const double size = (to - from) / cells;
    std::vector<Frame> coarse{frameAt(from, upper)};
    const auto reach = [&](const auto& self, const Frame& end) -> void {
      const Frame& start = coarse.back();
      const double width = end.azimuth - start.azimuth;
      if (width > kNarrowest && dot(start.across, end.across) < portable::cos(3.0 * mesh_.step)) {
        self(self, frameAt(start.azimuth + 0.5 * width, upper));
        self(self, end);
        return;
      }
      coarse.push_back(end);
    };
    for (int cell = 0; cell < cells; ++cell)
      if (const double azimuth = from + (cell + point_.offset) * size; azimuth - coarse.front().azimuth > kNarrowest)
        reach(reach, frameAt(azimuth, upper));
    reach(reach, frameAt(to, upper));
    Run run{{}, upper};
    for (std::size_t i = 0; i < coarse.size(); ++i) {
      if (i > 0) run.frames.push_back(frameAt(0.5 * (coarse[i - 1].azimuth + coarse[i].azimuth), upper));
      run.frames.push_back(coarse[i]);
    }
    for (std::size_t i = 1; i < run.frames.size(); ++i) {
      const double part = 0.5 * (run.frames[i].azimuth - run.frames[i - 1].azimuth) / kPi;
      run.frames[i - 1].weight += part;
      run.frames[i].weight += part;
    }
    all.push_back(std::move(run));
  }
  return all;
}

SheetTotals OrientationSheet::add(const SheetPoint& point, PixelFilm& film) {
  point_ = point;
  parts_ = table_.partsOf(point.index);
  const SunFrame about(point.toSun);
  level_ = tripleOf(about.ahead);
  left_ = tripleOf(about.left);
  SheetTotals totals;
  for (const Run& run : runs()) {
    if (mesh_.side == (run.upper ? CrystalSide::lower : CrystalSide::upper)) continue;
    for (const Frame& frame : run.frames) {
      const LightRow::Totals at = table_.totalsAt(frame.zeta, parts_);
      totals.intercepted += frame.weight * at.intercepted;
      totals.cutOff += frame.weight * at.cutOff;
    }
    upper_ = run.upper;
    for (const int number : table_.classes()) {
      if (!LightClass(number).isUndeviated()) {
        addClass(run, number, film);
        continue;
      }
      for (const Frame& frame : run.frames) {
        see(frame, number, nodes_[0]);
        if (!nodes_[0].dark) totals.undeviated += frame.weight * table_.meanOf(nodes_[0].density);
      }
    }
  }
  return totals;
}

PARHELION_ALSO_AVX2 void OrientationSheet::see(const Frame& frame, int number, Nodes& nodes) {
  nodes.dark = !table_.lightAt(frame.zeta, number, parts_, 1, nodes.light.data());
  if (nodes.dark) return;
  const LightClass of(number);
  const RelativeIndexOf<Four> index(all<Four>(point_.index));
  const auto spread = [](const Triple<double>& v) __attribute__((always_inline)) {
    return Triple<Four>{all<Four>(v.x), all<Four>(v.y), all<Four>(v.z)};
  };
  const Triple<Four> across = spread(frame.across), beside = spread(frame.beside), c = spread(frame.c),
                     left = spread(left_);
  for (std::size_t k = 0; k < nodes.light.size(); k += 4) {
    const Four light = higher(load<Four>(&nodes.light[k]), Four{});
    const ClassExit<Four> exit = of.exitAcross(frame.sinZeta, frame.cosZeta, load<Four>(&table_.sines()[k]),
                                               load<Four>(&table_.cosines()[k]), index);
    const auto& [along, aside, up] = exit.lightDir;
    store(&nodes.light[k], light);
    store(&nodes.density[k], Four(light * exit.transmittance));
    store(&nodes.excess[k], exit.excess);
    store(&nodes.along[k], along);
    store(&nodes.aside[k], aside);
    store(&nodes.up[k], up);
    const Triple<Four> common = along * across + up * c, by = aside * beside;
    for (int view = 0; view < views_; ++view) {
      Triple<Four> toSky = view & 1 ? by - common : -(common + by);
      if (view & 2) toSky = toSky - Four(2.0 * dot(left, toSky)) * left;
      const PicturePlace<Four> place = lens_.placeBeyond(toSky);
      const auto v = static_cast<std::size_t>(view);
      store(&nodes.x[v][k], place.x);
      store(&nodes.y[v][k], place.y);
      store(&nodes.seen[v][k], select(place.inside, all<Four>(1.0), Four{}));
    }
  }
}

void OrientationSheet::addClass(const Run& run, int number, PixelFilm& film) {
  const std::vector<Frame>& frames = run.frames;
  class_ = number;
  see(frames[0], number, nodes_[0]);
  if (frames.size() == 1) {
    if (nodes_[0].dark) return;
    addLines(frames[0], nodes_[0], 1, film);
    if (mesh_.coarse) addLines(frames[0], nodes_[0], 2, film);
    return;
  }
  for (std::size_t i = 1; i < frames.size(); ++i) {
    Nodes& nodes = nodes_[i % 3];
    see(frames[i], number, nodes);
    addRow(frames[i - 1], nodes_[(i + 2) % 3], frames[i], nodes, 1, film);
    if (mesh_.coarse && i % 2 == 0) addRow(frames[i - 2], nodes_[(i + 1) % 3], frames[i], nodes, 2, film);
  }
}

Triple<double> OrientationSheet::inView(int view, const Frame& frame, double along, double aside, double up) const {
  const Triple<double> dir = along * frame.across + (view & 1 ? -aside : aside) * frame.beside + up * frame.c;
  return view & 2 ? dir - 2.0 * dot(left_, dir) * left_ : dir;
}

SheetCorner OrientationSheet::cornerOf(const Frame& frame, const Nodes& nodes, int column, int view) const {
  const auto k = static_cast<std::size_t>(column);
  const double light = nodes.dark ? 0.0 : nodes.light[k];
  SheetCorner corner{frame.azimuth, table_.azimuthAt(column), light, 0.0, 0.0, {}};
  if (nodes.dark) return exitAt(corner, view);
  corner.density = nodes.density[k];
  corner.excess = nodes.excess[k];
  corner.lightDir = inView(view, frame, nodes.along[k], nodes.aside[k], nodes.up[k]);
  return corner;
}

SheetCorner OrientationSheet::exitAt(SheetCorner corner, int view) const {
  const Frame frame = frameAt(corner.row, upper_);
  const auto [sin, cos] = portable::sincos(corner.column);
  const ClassExit<double> exit =
      LightClass(class_).exitAcross(frame.sinZeta, frame.cosZeta, sin, cos, RelativeIndexOf<double>(point_.index));
  corner.density = corner.light * exit.transmittance;
  corner.excess = exit.excess;
  corner.lightDir = inView(view, frame, exit.lightDir.x, exit.lightDir.y, exit.lightDir.z);
  return corner;
}

void OrientationSheet::addRow(const Frame& a, const Nodes& na, const Frame& b, const Nodes& nb, int step,
                              PixelFilm& film) const {
  const double share = (b.azimuth - a.azimuth) / kPi * step / table_.columns() / views_;
  for (int view = 0; view < views_; ++view)
    cells_.addCells(
        na, nb, {view, table_.columns(), step, share, perLight(step)}, film,
        [&](bool behind, int column) { return cornerOf(behind ? b : a, behind ? nb : na, column, view); },
        [&](const SheetCorner& corner) { return exitAt(corner, view); });
}

void OrientationSheet::addLines(const Frame& frame, const Nodes& nodes, int step, PixelFilm& film) const {
  const double share = static_cast<double>(step) / table_.columns() / views_;
  for (int view = 0; view < views_; ++view)
    cells_.addLines(
        nodes, {view, table_.columns(), step, share, perLight(step)}, film,
        [&](int column) { return cornerOf(frame, nodes, column, view); },
        [&](const SheetCorner& corner) { return exitAt(corner, view); });
}

}  // namespace parhelion
