// SPDX-License-Identifier: Apache-2.0
#include "beam/sheet_cells.h"

#include <utility>

namespace parhelion {

namespace {

// A triangle is torn apart where its picture is so many times larger than it would be on the axis.
constexpr double kTorn = 8.0;
// Smaller triangles (rad) are flat.
constexpr double kFlat = 0.2;
// Such triangles are parted until they are smaller than this (pixels on the axis).
constexpr double kSmall = 0.7;

Triple<double> middle(const Triple<double>& a, const Triple<double>& b) {
  const Triple<double> sum = a + b;
  const double length = std::sqrt(dot(sum, sum));
  return length > 0.0 ? (1.0 / length) * sum : a;
}

}  // namespace

bool SheetCells::addNodes(const SheetNodes& na, const SheetNodes& nb, std::size_t k, std::size_t l, const Strip& strip,
                          PixelFilm& film) const {
  const std::pair<const SheetNodes*, std::size_t> all[4] = {{&na, k}, {&na, l}, {&nb, k}, {&nb, l}};
  const auto v = static_cast<std::size_t>(strip.view);
  double light = 0.0;
  for (const auto& [nodes, node] : all) light += nodes->dark ? 0.0 : strip.share * nodes->light[node];
  if (light >= picture_.faint) return false;
  for (const auto& [nodes, node] : all)
    if (!nodes->dark && nodes->excess[node] > 0.0 && nodes->seen[v][node] > 0.0)
      film.add({nodes->x[v][node], nodes->y[v][node], 0.25 * strip.share * nodes->density[node]}, strip.per);
  return true;
}

void SheetCells::addSky(const SkyLight& a, const SkyLight& b, const SkyLight& c, int depth, const Four& per,
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
  if (seen == 0 || nearest < picture_.widest - size) return;
  bool torn = seen < 3;
  for (int k = 0; k < 3 && !torn; ++k) {
    const LitPlace &p = at[k], &q = at[(k + 1) % 3];
    const double most = kTorn * lens_.focal;
    torn = (p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y) > most * most * sides[k] + 1.0;
  }
  if (!torn) return film.addTriangle(at[0], at[1], at[2], per);
  if (seen < 3 && picture_.hasEdge && size < kFlat) return addSeen(all, at, per, film);
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

void SheetCells::addSeen(const SkyLight* const (&all)[3], const LitPlace (&at)[3], const Four& per,
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

}  // namespace parhelion
