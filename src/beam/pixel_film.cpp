// SPDX-License-Identifier: Apache-2.0
#include "beam/pixel_film.h"

#include <algorithm>
#include <cmath>

namespace parhelion {

namespace {

// Faint light: points to a pixel's side, and at most along a side.
constexpr double kFaintPoints = 1.6, kMostFaint = 64.0;

}  // namespace

PARHELION_ALSO_AVX2 void PixelFilm::addTriangle(const LitPlace& a, const LitPlace& b, const LitPlace& c,
                                                const Four& per) {
  shareOverCells(
      a, b, c, width_,
      height_, [&](int x, int y, double light) __attribute__((always_inline)) { addTo(x, y, light, per); });
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
