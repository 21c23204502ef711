// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "beam/cosine_table.h"
#include "beam/lattice_points.h"
#include "beam/light_segments.h"
#include "beam/triangle_cells.h"
#include "math/aligned_vector.h"
#include "math/inline.h"

namespace parhelion {

/// Light of a class at one orientation: angle of c from the light and azimuth of the light about c (rad), what meets
/// the exit and what leaves, the squared cosine outside, and where it goes: place among the rings, turn about the sun
/// in cells.
struct RingCorner {
  double alpha, phi, light, density, excess, place, turn;
};

/// As many floats side by side as there are channels.
template <int C>
struct Channels {
  using Floats [[gnu::vector_size(C * sizeof(float))]] = float;
};

/// Cells of rings along which nothing is told apart.
inline constexpr int kNoTurns = 2;

/// Light in rings about the sun, for one azimuth of c, in C channels. Each is the same on both sides.
template <int C>
class RingFilm {
 public:
  using Floats = typename Channels<C>::Floats;

  RingFilm(int cells, int first, int end)
      : cells_(cells),
        beyond_(std::min(kBeyond, cells)),
        width_(cells + 2 * beyond_),
        first_(first),
        end_(end),
        film_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(end - first)),
        lit_(static_cast<std::size_t>(end - first), 0) {}

  /// Adds the light of a triangle by its places among the rings and its turns, which may be of any sign.
  PARHELION_INLINE void add(const RingCorner& a, const RingCorner& b, const RingCorner& c, double share,
                            const Floats& per) {
    const double light[3] = {share * a.density, share * b.density, share * c.density};
    if (!(light[0] + light[1] + light[2] > 0.0)) return;
    // One turn is a neighbour of the others; the sky is the same on both sides.
    double turn[3] = {a.turn, b.turn, c.turn};
    const double half = cells_;
    for (double& t : turn) t = nearest(t, turn[0]);
    const double mean = turn[0] + turn[1] + turn[2];
    if (mean < 0.0)
      for (double& t : turn) t = -t;
    if (std::abs(mean) > 3.0 * half)
      for (double& t : turn) t = 2.0 * half - t;
    const double least = std::min({turn[0], turn[1], turn[2]}), most = std::max({turn[0], turn[1], turn[2]});
    if (least < -beyond_ || most > half + beyond_)
      for (double& t : turn) t = std::clamp(std::abs(t), 0.0, half);
    const double low = std::min({a.place, b.place, c.place}), high = std::max({a.place, b.place, c.place});
    if (!(high >= first_ && low < end_)) return;
    const int lastRow = std::min(static_cast<int>(high), end_ - 1);
    for (int ring = std::max(static_cast<int>(low), first_); ring <= lastRow; ++ring) lit_[rowOf(ring)] = 1;
    shareOverCells(
        {turn[0] + beyond_, a.place, light[0]}, {turn[1] + beyond_, b.place, light[1]},
        {turn[2] + beyond_, c.place, light[2]}, width_, end_,
        [&](int x, int y, double own) __attribute__((always_inline)) {
          film_[rowOf(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)] +=
              static_cast<float>(own) * per;
        },
        first_);
  }

  /// The same of two triangles that share the edge from the second corner to the third, by points.
  PARHELION_INLINE void addFaint(const RingCorner (&corner)[4], double share, const Floats& per) {
    double turn[4];
    for (int k = 0; k < 4; ++k) turn[k] = nearest(corner[k].turn, corner[0].turn);
    const RingCorner &a = corner[0], &b = corner[1], &c = corner[2], &d = corner[3];
    const auto parts = [](double x0, double y0, double x1, double y1) __attribute__((always_inline)) {
      return std::min(1.0 + std::floor(kFaintPoints * std::max(std::abs(x1 - x0), std::abs(y1 - y0))), kMostPoints);
    };
    const double rows = std::max(parts(turn[0], a.place, turn[2], c.place), parts(turn[1], b.place, turn[3], d.place)),
                 columns =
                     std::max(parts(turn[0], a.place, turn[1], b.place), parts(turn[2], c.place, turn[3], d.place));
    const double perRow = 1.0 / rows, perColumn = 1.0 / columns, own = 2.0 * share * perRow * perColumn;
    for (double i = 0.5; i < rows; i += 1.0) {
      const double t = i * perRow;
      const double x = turn[0] + t * (turn[2] - turn[0]), y = a.place + t * (c.place - a.place),
                   light = own * (a.density + t * (c.density - a.density));
      const double dx = perColumn * (turn[1] + t * (turn[3] - turn[1]) - x),
                   dy = perColumn * (b.place + t * (d.place - b.place) - y),
                   dLight = perColumn * (own * (b.density + t * (d.density - b.density)) - light);
      for (double j = 0.5; j < columns; j += 1.0) {
        addPoint(x + j * dx, y + j * dy, light + j * dLight, per);
      }
    }
  }

  /// The same for light between two indices, at each of which it fills a quad. `at` says where between them its
  /// colours are.
  PARHELION_INLINE void addSpread(const RingCorner (&from)[4], const RingCorner (&to)[4], double share,
                                  const std::array<double, LightSegments::kColours>& at,
                                  const std::array<Floats, LightSegments::kColours>& colours, unsigned start) {
    if (cells_ == kNoTurns) return addAlong(from, to, share, at, colours, start);
    double turn[2][4];
    double moved = 0.0;
    for (int k = 0; k < 4; ++k) {
      turn[0][k] = nearest(from[k].turn, from[0].turn);
      turn[1][k] = nearest(to[k].turn, from[0].turn);
      moved = std::max({moved, std::abs(to[k].place - from[k].place), std::abs(turn[1][k] - turn[0][k])});
    }
    const auto parts = [&](int a, int b) __attribute__((always_inline)) {
      const double across = std::max(std::abs(turn[0][a] - turn[0][b]), std::abs(from[a].place - from[b].place));
      return std::min(1.0 + std::floor(kSpreadPoints * across), kMostPoints);
    };
    const double rows = std::max(parts(0, 2), parts(1, 3));
    double columns = std::max(parts(0, 1), parts(2, 3));
    columns = std::max(columns, std::min(std::ceil(kSpreadPoints * moved / rows), kMostPoints));
    const double perRow = 1.0 / rows, perColumn = 1.0 / columns, own = 2.0 * share * perRow * perColumn;
    struct Line {
      double x, y, light, dx, dy, dLight;
    };
    for (double i = 0.5; i < rows; i += 1.0) {
      const double t = i * perRow;
      const auto line = [&](const RingCorner(&c)[4], const double(&turns)[4]) __attribute__((always_inline)) {
        Line one;
        one.x = turns[0] + t * (turns[2] - turns[0]);
        one.y = c[0].place + t * (c[2].place - c[0].place);
        one.light = own * (c[0].density + t * (c[2].density - c[0].density));
        one.dx = perColumn * (turns[1] + t * (turns[3] - turns[1]) - one.x);
        one.dy = perColumn * (c[1].place + t * (c[3].place - c[1].place) - one.y);
        one.dLight = perColumn * (own * (c[1].density + t * (c[3].density - c[1].density)) - one.light);
        return one;
      };
      const Line p = line(from, turn[0]), q = line(to, turn[1]);
      for (double j = 0.5; j < columns; j += 1.0) {
        const std::size_t which = start++ * 5 % LightSegments::kColours;
        const double s = at[which];
        double px = p.x + j * p.dx, py = p.y + j * p.dy, light = p.light + j * p.dLight;
        px += s * (q.x + j * q.dx - px);
        py += s * (q.y + j * q.dy - py);
        light += s * (q.light + j * q.dLight - light);
        addPoint(px, py, light, colours[which]);
      }
      start += 3;
    }
  }

  /// Takes a ring's light out: pairs of cells.
  void take(int ring, std::vector<CosineTable::CellPair<C>>& pairs) {
    pairs.clear();
    const std::size_t r = rowOf(ring);
    Floats* const cells = film_.data() + r * static_cast<std::size_t>(width_) + beyond_;
    if (!lit_[r]) return;
    for (int k = 1; k <= beyond_; ++k) {
      cells[k - 1] += cells[-k];
      cells[cells_ - k] += cells[cells_ - 1 + k];
    }
    for (int cell = 0; cell < cells_ / 2; ++cell) {
      const Floats a = cells[cell], b = cells[cells_ - 1 - cell], sum = a + b, difference = a - b;
      CosineTable::CellPair<C> pair{cell, {}, {}};
      float any = 0.0F;
      for (int c = 0; c < C; ++c) {
        pair.sum[static_cast<std::size_t>(c)] = sum[c];
        pair.difference[static_cast<std::size_t>(c)] = difference[c];
        any += sum[c];
      }
      if (any != 0.0F) pairs.push_back(pair);
    }
    std::fill(cells - beyond_, cells + cells_ + beyond_, Floats{});
    lit_[r] = 0;
  }

 private:
  /// addSpread() where only rings matter.
  PARHELION_INLINE void addAlong(const RingCorner (&from)[4], const RingCorner (&to)[4], double share,
                                 const std::array<double, LightSegments::kColours>& at,
                                 const std::array<Floats, LightSegments::kColours>& colours, unsigned start) {
    SpreadLight light;
    double least = from[0].place, most = from[0].place;
    for (int k = 0; k < 4; ++k) {
      light.from.place[k] = from[k].place;
      light.from.density[k] = from[k].density;
      light.to.place[k] = to[k].place;
      light.to.density[k] = to[k].density;
      least = std::min({least, from[k].place, to[k].place});
      most = std::max({most, from[k].place, to[k].place});
    }
    LatticePoints points(light, 2.0 * share, 1 + static_cast<int>(kRingPoints * (most - least)), at, start);
    while (const int count = points.next())
      for (int k = 0; k < count; ++k) addPoint(0.0, points.place(k), points.light(k), colours[points.colourOf(k)]);
  }

  // Cells beyond either end of the half ring, for triangles that reach over it.
  static constexpr int kBeyond = 32;
  // Points to a cell's side, of faint light and of light between two indices, and at most along a side.
  static constexpr double kFaintPoints = 1.2, kSpreadPoints = 2.5, kMostPoints = 64.0;
  // Points to a ring along which nothing is told apart.
  static constexpr double kRingPoints = 4.0;

  /// A turn, or whole turns from it, that is less than half of one from another.
  PARHELION_INLINE double nearest(double turn, double other) const {
    const double half = cells_;
    if (turn - other > half) turn -= 2.0 * half;
    if (turn - other < -half) turn += 2.0 * half;
    return turn;
  }

  PARHELION_INLINE void addPoint(double turn, double place, double light, const Floats& per) {
    const double half = cells_;
    double px = std::abs(turn);
    if (px > half) px = 2.0 * half - px;
    if (!(place >= first_ && place < end_ && px >= 0.0)) return;
    const int column = std::min(static_cast<int>(px), cells_ - 1) + beyond_;
    const std::size_t row = rowOf(static_cast<int>(place));
    film_[row * static_cast<std::size_t>(width_) + static_cast<std::size_t>(column)] += static_cast<float>(light) * per;
    lit_[row] = 1;
  }

  std::size_t rowOf(int ring) const { return static_cast<std::size_t>(ring - first_); }

  int cells_, beyond_, width_, first_, end_;
  AlignedVector<Floats> film_;
  std::vector<char> lit_;  // rows that have light
};

}  // namespace parhelion
