// SPDX-License-Identifier: Apache-2.0
#include "beam/pixel_film.h"

#include <algorithm>
#include <cmath>

#include "beam/triangle_steps.h"

namespace parhelion {

namespace {

// Faint light: points to a pixel's side, and at most along a side.
constexpr double kFaintPoints = 1.6, kMostFaint = 64.0;

/// A corner of a part of a triangle: `u` and `v` say where in the triangle it lies, so that no triangle is too thin to
/// tell how much of it a part is.
struct Corner {
  double x, y, light, u, v;
};

PARHELION_INLINE Corner between(const Corner& a, const Corner& b, double t) {
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.light + t * (b.light - a.light), a.u + t * (b.u - a.u),
          a.v + t * (b.v - a.v)};
}

struct Polygon {
  Corner corner[6];
  int count = 0;
};

/// The part of a convex polygon where side * (y - edge) >= 0.
PARHELION_INLINE void clip(const Polygon& from, double edge, double side, Polygon& to) {
  to.count = 0;
  for (int k = 0; k < from.count; ++k) {
    const Corner &a = from.corner[k], &b = from.corner[k + 1 < from.count ? k + 1 : 0];
    const double da = side * (a.y - edge), db = side * (b.y - edge);
    if (da >= 0.0) to.corner[to.count++] = a;
    if ((da > 0.0 && db < 0.0) || (da < 0.0 && db > 0.0)) to.corner[to.count++] = between(a, b, da / (da - db));
  }
}

}  // namespace

PARHELION_ALSO_AVX2 void PixelFilm::addTriangle(const LitPlace& a, const LitPlace& b, const LitPlace& c,
                                                const Four& per) {
  const double lowX = std::min({a.x, b.x, c.x}), highX = std::max({a.x, b.x, c.x});
  const double lowY = std::min({a.y, b.y, c.y}), highY = std::max({a.y, b.y, c.y});
  if (!(highX >= 0.0 && lowX < width_ && highY >= 0.0 && lowY < height_)) return;
  const double column = std::floor(lowX), row = std::floor(lowY), last = std::min(std::floor(highY), height_ - 1.0);
  const bool oneColumn = highX < column + 1.0, oneRow = highY < row + 1.0;
  if (oneColumn && oneRow) {
    if (column < 0.0 || row < 0.0) return;
    return addTo(static_cast<int>(column), static_cast<int>(row), (a.light + b.light + c.light) * (1.0 / 3.0), per);
  }
  if (oneColumn) {
    double place[3] = {a.y, b.y, c.y}, light[3] = {a.light, b.light, c.light};
    return shareOut(
        place, light, height_, [&](double y, double part) __attribute__((always_inline)) {
          addTo(static_cast<int>(column), static_cast<int>(y), part, per);
        });
  }
  if (oneRow) {
    double place[3] = {a.x, b.x, c.x}, light[3] = {a.light, b.light, c.light};
    return shareOut(
        place, light, width_, [&](double x, double part) __attribute__((always_inline)) {
          addTo(static_cast<int>(x), static_cast<int>(row), part, per);
        });
  }
  Polygon rest, band, above;
  rest.corner[0] = {a.x, a.y, a.light, 0.0, 0.0};
  rest.corner[1] = {b.x, b.y, b.light, 1.0, 0.0};
  rest.corner[2] = {c.x, c.y, c.light, 0.0, 1.0};
  rest.count = 3;
  const double first = std::max(row, 0.0);
  if (row < first) {
    clip(rest, first, 1.0, above);
    rest = above;
  }
  for (double y = first; y <= last; y += 1.0) {
    clip(rest, y + 1.0, -1.0, band);
    for (int k = 2; k < band.count; ++k) {
      const Corner &p = band.corner[0], &q = band.corner[k - 1], &r = band.corner[k];
      const double share = std::abs((q.u - p.u) * (r.v - p.v) - (q.v - p.v) * (r.u - p.u));
      double place[3] = {p.x, q.x, r.x}, light[3] = {share * p.light, share * q.light, share * r.light};
      shareOut(
          place, light, width_, [&](double x, double part) __attribute__((always_inline)) {
            addTo(static_cast<int>(x), static_cast<int>(y), part, per);
          });
    }
    if (y == last) break;
    clip(rest, y + 1.0, 1.0, above);
    rest = above;
  }
}

PARHELION_ALSO_AVX2 void PixelFilm::addFaintQuad(const LitPlace (&corner)[4], const Four& per) {
  const LitPlace &a = corner[0], &b = corner[1], &c = corner[2], &d = corner[3];
  const double lowX = std::min({a.x, b.x, c.x, d.x}), highX = std::max({a.x, b.x, c.x, d.x});
  const double lowY = std::min({a.y, b.y, c.y, d.y}), highY = std::max({a.y, b.y, c.y, d.y});
  if (!(highX >= 0.0 && lowX < width_ && highY >= 0.0 && lowY < height_)) return;
  const auto parts = [](double x0, double y0, double x1, double y1) __attribute__((always_inline)) {
    return std::min(1.0 + std::floor(kFaintPoints * std::max(std::abs(x1 - x0), std::abs(y1 - y0))), kMostFaint);
  };
  const double rows = std::max(parts(a.x, a.y, c.x, c.y), parts(b.x, b.y, d.x, d.y)),
               columns = std::max(parts(a.x, a.y, b.x, b.y), parts(c.x, c.y, d.x, d.y));
  const double perRow = 1.0 / rows, perColumn = 1.0 / columns, share = perRow * perColumn;
  for (double row = 0.5; row < rows; row += 1.0) {
    const double t = row * perRow, x = a.x + t * (c.x - a.x), y = a.y + t * (c.y - a.y),
                 light = share * (a.light + t * (c.light - a.light));
    const double dx = perColumn * (b.x + t * (d.x - b.x) - x), dy = perColumn * (b.y + t * (d.y - b.y) - y),
                 dLight = perColumn * (share * (b.light + t * (d.light - b.light)) - light);
    for (double column = 0.5; column < columns; column += 1.0) {
      const double px = x + column * dx, py = y + column * dy;
      if (px >= 0.0 && px < width_ && py >= 0.0 && py < height_)
        addTo(static_cast<int>(px), static_cast<int>(py), light + column * dLight, per);
    }
  }
}

void PixelFilm::addLine(const LitPlace& a, const LitPlace& b, const Four& per) {
  // From crossing to crossing of the pixels' edges; the share of the line's light up to t is that of a linear density.
  const double dx = b.x - a.x, dy = b.y - a.y;
  const auto nextEdge = [](double at, double step) { return step > 0.0 ? std::floor(at) + 1.0 : std::ceil(at) - 1.0; };
  double edgeX = nextEdge(a.x, dx), edgeY = nextEdge(a.y, dy), t = 0.0;
  while (t < 1.0) {
    const double tx = dx != 0.0 ? (edgeX - a.x) / dx : 2.0, ty = dy != 0.0 ? (edgeY - a.y) / dy : 2.0;
    const double end = std::min({tx, ty, 1.0});
    if (end > t) {
      const double middle = 0.5 * (t + end);
      add({a.x + middle * dx, a.y + middle * dy, (end - t) * (a.light + middle * (b.light - a.light))}, per);
    }
    t = std::max(end, t);
    if (tx <= end) edgeX += dx > 0.0 ? 1.0 : -1.0;
    if (ty <= end) edgeY += dy > 0.0 ? 1.0 : -1.0;
    if (end >= 1.0) break;
  }
}

}  // namespace parhelion
