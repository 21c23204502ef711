// SPDX-License-Identifier: Apache-2.0
#include "beam/orientation_sheet.h"

#include <algorithm>
#include <cmath>

#include "beam/edge_parts.h"
#include "beam/sun_frame.h"
#include "math/portable.h"

namespace parhelion {

namespace {

// Triangles across which light stops getting out are parted so often, with exact directions; those that the camera
// tears apart, too.
constexpr int kEdgeDepth = 2, kTornDepth = 5;
// Parts of a line that is one of these.
constexpr int kLineParts = 32;
// A triangle is torn apart where its picture is so many times larger than it would be on the axis. All that are wider
// than this share of the picture are looked at.
constexpr double kTorn = 8.0, kWide = 0.125;
// Smaller triangles (rad) are flat.
constexpr double kFlat = 0.2;
// Such triangles are parted until they are smaller than this (pixels on the axis).
constexpr double kSmall = 0.7;
// c that moves less than this (rad) stands still; azimuths are parted no further than to this.
constexpr double kStill = 1e-7, kNarrowest = 1e-6;

Triple<double> tripleOf(const Vec3& v) { return {v.x, v.y, v.z}; }

Triple<double> cross(const Triple<double>& a, const Triple<double>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

double lengthOf(const Triple<double>& v) { return std::sqrt(dot(v, v)); }

Triple<double> middle(const Triple<double>& a, const Triple<double>& b) {
  const Triple<double> sum = a + b;
  const double length = lengthOf(sum);
  return length > 0.0 ? (1.0 / length) * sum : a;
}

}  // namespace

OrientationSheet::OrientationSheet(const LightTable& table, const Lens& lens, const SheetMesh& mesh)
    : table_(table), lens_(lens), mesh_(mesh), views_(mesh.folds ? 2 : kViews) {
  const auto room = static_cast<std::size_t>(table.room());
  for (Nodes& nodes : nodes_) {
    for (auto* row : {&nodes.light, &nodes.density, &nodes.excess, &nodes.along, &nodes.aside, &nodes.up})
      row->resize(room);
    for (auto* views : {&nodes.x, &nodes.y, &nodes.seen})
      for (auto& row : *views) row.resize(room);
  }
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
      const LightTable::Totals at = table_.totalsAt(frame.zeta, parts_);
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

OrientationSheet::Corner OrientationSheet::cornerOf(const Frame& frame, const Nodes& nodes, int column,
                                                    int view) const {
  const auto k = static_cast<std::size_t>(column);
  const double light = nodes.dark ? 0.0 : nodes.light[k];
  Corner corner{frame.azimuth, table_.azimuthAt(column), light, 0.0, 0.0, {}};
  if (nodes.dark) return exitAt(corner, view);
  corner.density = nodes.density[k];
  corner.excess = nodes.excess[k];
  corner.lightDir = inView(view, frame, nodes.along[k], nodes.aside[k], nodes.up[k]);
  return corner;
}

OrientationSheet::Corner OrientationSheet::exitAt(Corner corner, int view) const {
  const Frame frame = frameAt(corner.azimuth, upper_);
  const auto [sin, cos] = portable::sincos(corner.phi);
  const ClassExit<double> exit =
      LightClass(class_).exitAcross(frame.sinZeta, frame.cosZeta, sin, cos, RelativeIndexOf<double>(point_.index));
  corner.density = corner.light * exit.transmittance;
  corner.excess = exit.excess;
  corner.lightDir = inView(view, frame, exit.lightDir.x, exit.lightDir.y, exit.lightDir.z);
  return corner;
}

void OrientationSheet::addRow(const Frame& a, const Nodes& na, const Frame& b, const Nodes& nb, int step,
                              PixelFilm& film) const {
  if (na.dark && nb.dark) return;
  const Four per = perLight(step);
  const double share = (b.azimuth - a.azimuth) / kPi * step / table_.columns() / views_;
  const double most = kWide * lens_.width, faint = mesh_.faint;
  for (std::size_t v = 0; v < static_cast<std::size_t>(views_); ++v) {
    for (int column = 0; column < table_.columns(); column += step) {
      const auto k = static_cast<std::size_t>(column), l = k + static_cast<std::size_t>(step);
      if (!na.dark && !nb.dark) {
        if (na.light[k] + na.light[l] + nb.light[k] + nb.light[l] == 0.0 ||
            std::max({na.excess[k], na.excess[l], nb.excess[k], nb.excess[l]}) <= 0.0)
          continue;
        const LitPlace p[4] = {{na.x[v][k], na.y[v][k], share * na.density[k]},
                               {na.x[v][l], na.y[v][l], share * na.density[l]},
                               {nb.x[v][k], nb.y[v][k], share * nb.density[k]},
                               {nb.x[v][l], nb.y[v][l], share * nb.density[l]}};
        const bool out = na.excess[k] > 0.0 && na.excess[l] > 0.0 && nb.excess[k] > 0.0 && nb.excess[l] > 0.0;
        const double seen = na.seen[v][k] + na.seen[v][l] + nb.seen[v][k] + nb.seen[v][l];
        if (seen == 0.0 && out) continue;
        if (out && seen == 4.0 && std::abs(p[0].x - p[3].x) < most && std::abs(p[1].x - p[2].x) < most) {
          const double w = std::abs(p[0].x - p[3].x) + std::abs(p[1].x - p[2].x),
                       h = std::abs(p[0].y - p[3].y) + std::abs(p[1].y - p[2].y);
          if (p[0].light + p[1].light + p[2].light + p[3].light < faint * std::max(1.0, w * h))
            film.addFaintQuad(p, per);
          else
            film.addQuad(p, per);
          continue;
        }
      }
      if (addNodes(na, nb, k, l, v, share, per, film)) continue;
      const int view = static_cast<int>(v);
      const Corner c[4] = {cornerOf(a, na, column, view), cornerOf(a, na, column + step, view),
                           cornerOf(b, nb, column, view), cornerOf(b, nb, column + step, view)};
      const int depth = step == 1 ? kEdgeDepth : kEdgeDepth + 1;
      const auto between = [&](const Corner& p, const Corner& q) {
        return exitAt({0.5 * (p.azimuth + q.azimuth), 0.5 * (p.phi + q.phi), 0.5 * (p.light + q.light), 0.0, 0.0, {}},
                      view);
      };
      const auto add = [&](const Corner& p, const Corner& q, const Corner& r, double part) {
        if (p.light + q.light + r.light == 0.0) return;
        addSky({-p.lightDir, part * p.density}, {-q.lightDir, part * q.density}, {-r.lightDir, part * r.density},
               kTornDepth, per, film);
      };
      addParts(c[0], c[1], c[2], 0.5 * share, depth, between, add);
      addParts(c[1], c[3], c[2], 0.5 * share, depth, between, add);
    }
  }
}

bool OrientationSheet::addNodes(const Nodes& na, const Nodes& nb, std::size_t k, std::size_t l, std::size_t view,
                                double share, const Four& per, PixelFilm& film) const {
  const std::pair<const Nodes*, std::size_t> all[4] = {{&na, k}, {&na, l}, {&nb, k}, {&nb, l}};
  double light = 0.0;
  for (const auto& [nodes, node] : all) light += nodes->dark ? 0.0 : share * nodes->light[node];
  if (light >= mesh_.faint) return false;
  for (const auto& [nodes, node] : all)
    if (!nodes->dark && nodes->excess[node] > 0.0 && nodes->seen[view][node] > 0.0)
      film.add({nodes->x[view][node], nodes->y[view][node], 0.25 * share * nodes->density[node]}, per);
  return true;
}

void OrientationSheet::addSky(const SkyLight& a, const SkyLight& b, const SkyLight& c, int depth, const Four& per,
                              PixelFilm& film) const {
  const SkyLight* all[3] = {&a, &b, &c};
  LitPlace at[3];
  int seen = 0;
  double nearest = -1.0;
  for (int k = 0; k < 3; ++k) {
    const PicturePlace<double> place = lens_.placeBeyond(all[k]->toSky);
    at[k] = {place.x, place.y, all[k]->light};
    seen += place.inside;
    nearest = std::max(nearest, dot(lens_.forward, all[k]->toSky));
  }
  const auto squared = [](const SkyLight& p, const SkyLight& q) {
    const Triple<double> d = p.toSky - q.toSky;
    return dot(d, d);
  };
  const double sides[3] = {squared(a, b), squared(b, c), squared(c, a)};
  const double size = std::sqrt(std::max({sides[0], sides[1], sides[2]}));
  if (seen == 0 || nearest < mesh_.widest - size) return;
  bool torn = seen < 3;
  for (int k = 0; k < 3 && !torn; ++k) {
    const LitPlace &p = at[k], &q = at[(k + 1) % 3];
    const double most = kTorn * lens_.focal;
    torn = (p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y) > most * most * sides[k] + 1.0;
  }
  if (!torn) return film.addTriangle(at[0], at[1], at[2], per);
  if (seen < 3 && mesh_.hasEdge && size < kFlat) return addSeen(all, at, per, film);
  if (depth == 0 || size * lens_.focal < kSmall) {
    const SkyLight centre{middle(a.toSky, middle(b.toSky, c.toSky)), (a.light + b.light + c.light) / 3.0};
    if (const PicturePlace<double> place = lens_.placeBeyond(centre.toSky); place.inside)
      film.add({place.x, place.y, centre.light}, per);
    return;
  }
  const auto half = [](const SkyLight& p, const SkyLight& q) {
    return SkyLight{middle(p.toSky, q.toSky), 0.5 * (p.light + q.light)};
  };
  const SkyLight ab = half(a, b), bc = half(b, c), ca = half(c, a);
  const auto quarter = [](SkyLight light) {
    light.light *= 0.25;
    return light;
  };
  addSky(quarter(a), quarter(ab), quarter(ca), depth - 1, per, film);
  addSky(quarter(ab), quarter(b), quarter(bc), depth - 1, per, film);
  addSky(quarter(ca), quarter(bc), quarter(c), depth - 1, per, film);
  addSky(quarter(ab), quarter(bc), quarter(ca), depth - 1, per, film);
}

void OrientationSheet::addSeen(const SkyLight* const (&all)[3], const LitPlace (&at)[3], const Four& per,
                               PixelFilm& film) const {
  // Heights above the edges are as good as linear across so small a triangle.
  struct Vertex {
    LitPlace at;
    double overCircle, overHorizon, u, v;
  };
  std::array<Vertex, 8> polygon{}, kept{};
  std::size_t count = 3;
  for (std::size_t k = 0; k < 3; ++k)
    polygon[k] = {at[k], dot(lens_.forward, all[k]->toSky) - lens_.minCosine, all[k]->toSky.z - lens_.lowest,
                  k == 1 ? 1.0 : 0.0, k == 2 ? 1.0 : 0.0};
  for (double Vertex::*height : {&Vertex::overCircle, &Vertex::overHorizon}) {
    std::size_t left = 0;
    for (std::size_t k = 0; k < count; ++k) {
      const Vertex &p = polygon[k], &q = polygon[(k + 1) % count];
      const double hp = p.*height, hq = q.*height;
      if (hp >= 0.0) kept[left++] = p;
      if ((hp >= 0.0) == (hq >= 0.0)) continue;
      const double t = hp / (hp - hq);
      const auto mix = [t](double a, double b) { return a + t * (b - a); };
      kept[left++] = {{mix(p.at.x, q.at.x), mix(p.at.y, q.at.y), mix(p.at.light, q.at.light)},
                      mix(p.overCircle, q.overCircle),
                      mix(p.overHorizon, q.overHorizon),
                      mix(p.u, q.u),
                      mix(p.v, q.v)};
    }
    count = left;
    polygon = kept;
  }
  for (std::size_t k = 2; k < count; ++k) {
    const Vertex &p = polygon[0], &q = polygon[k - 1], &r = polygon[k];
    const double share = std::abs((q.u - p.u) * (r.v - p.v) - (q.v - p.v) * (r.u - p.u));
    const auto part = [share](const LitPlace& place) { return LitPlace{place.x, place.y, share * place.light}; };
    film.addTriangle(part(p.at), part(q.at), part(r.at), per);
  }
}

void OrientationSheet::addLines(const Frame& frame, const Nodes& nodes, int step, PixelFilm& film) const {
  if (nodes.dark) return;
  const Four per = perLight(step);
  const double share = static_cast<double>(step) / table_.columns() / views_, most = kWide * lens_.width;
  for (std::size_t v = 0; v < static_cast<std::size_t>(views_); ++v)
    for (int column = 0; column < table_.columns(); column += step) {
      const auto k = static_cast<std::size_t>(column), l = k + static_cast<std::size_t>(step);
      const LitPlace a{nodes.x[v][k], nodes.y[v][k], share * nodes.density[k]},
          b{nodes.x[v][l], nodes.y[v][l], share * nodes.density[l]};
      if (nodes.excess[k] > 0.0 && nodes.excess[l] > 0.0 && nodes.seen[v][k] + nodes.seen[v][l] == 2.0 &&
          std::abs(a.x - b.x) < most) {
        film.addLine(a, b, per);
        continue;
      }
      // Point by point.
      const int view = static_cast<int>(v), parts = kLineParts * step;
      const Corner from = cornerOf(frame, nodes, column, view), to = cornerOf(frame, nodes, column + step, view);
      if (from.light + to.light == 0.0) continue;
      for (int part = 0; part < parts; ++part) {
        const double t = (part + 0.5) / parts;
        const Corner at = exitAt(
            {frame.azimuth, from.phi + t * (to.phi - from.phi), from.light + t * (to.light - from.light), 0.0, 0.0, {}},
            view);
        if (const PicturePlace<double> place = lens_.placeBeyond(-at.lightDir); at.excess > 0.0 && place.inside)
          film.add({place.x, place.y, share * at.density / parts}, per);
      }
    }
}

}  // namespace parhelion
