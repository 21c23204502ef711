// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "beam/triangle_steps.h"

namespace parhelion {

/// A place on a grid, in cells, and light there.
struct LitPlace {
  double x, y, light;
};

namespace triangle_cells {

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

}  // namespace triangle_cells

/// Shares the light of a triangle out over the cells of a grid: across the triangle both the place and the density are
/// linear. The mean of the light at its corners is all its light. It may be as thin as a line. Calls add(x, y, light)
/// for cells within the grid, from row `first` on. Exact.
template <class Add>
PARHELION_INLINE void shareOverCells(const LitPlace& a, const LitPlace& b, const LitPlace& c, int width, int height,
                                     const Add& add, int first = 0) {
  using namespace triangle_cells;
  const double lowX = std::min({a.x, b.x, c.x}), highX = std::max({a.x, b.x, c.x});
  const double lowY = std::min({a.y, b.y, c.y}), highY = std::max({a.y, b.y, c.y});
  if (!(highX >= 0.0 && lowX < width && highY >= first && lowY < height)) return;
  const double column = std::floor(lowX), row = std::floor(lowY), last = std::min(std::floor(highY), height - 1.0);
  const bool oneColumn = highX < column + 1.0, oneRow = highY < row + 1.0;
  if (oneColumn && oneRow) {
    if (column < 0.0 || row < first) return;
    return add(static_cast<int>(column), static_cast<int>(row), (a.light + b.light + c.light) * (1.0 / 3.0));
  }
  if (oneColumn) {
    double place[3] = {a.y, b.y, c.y}, light[3] = {a.light, b.light, c.light};
    return shareOut(
        place, light, height, [&](double y, double part) __attribute__((always_inline)) {
          if (y >= first) add(static_cast<int>(column), static_cast<int>(y), part);
        });
  }
  if (oneRow) {
    double place[3] = {a.x, b.x, c.x}, light[3] = {a.light, b.light, c.light};
    return shareOut(
        place, light, width, [&](double x, double part) __attribute__((always_inline)) {
          add(static_cast<int>(x), static_cast<int>(row), part);
        });
  }
  // Each row's part is cut from the whole triangle: it is the same to the bit whichever rows there are.
  Polygon whole, above, band;
  whole.corner[0] = {a.x, a.y, a.light, 0.0, 0.0};
  whole.corner[1] = {b.x, b.y, b.light, 1.0, 0.0};
  whole.corner[2] = {c.x, c.y, c.light, 0.0, 1.0};
  whole.count = 3;
  for (double y = std::max(row, double(first)); y <= last; y += 1.0) {
    clip(whole, y, 1.0, above);
    clip(above, y + 1.0, -1.0, band);
    for (int k = 2; k < band.count; ++k) {
      const Corner &p = band.corner[0], &q = band.corner[k - 1], &r = band.corner[k];
      const double share = std::abs((q.u - p.u) * (r.v - p.v) - (q.v - p.v) * (r.u - p.u));
      double place[3] = {p.x, q.x, r.x}, light[3] = {share * p.light, share * q.light, share * r.light};
      shareOut(
          place, light, width, [&](double x, double part) __attribute__((always_inline)) {
            add(static_cast<int>(x), static_cast<int>(y), part);
          });
    }
  }
}

}  // namespace parhelion
