// SPDX-License-Identifier: Apache-2.0
#include "recon/published/nearest_hits.h"

#include "parallel/loops.h"

#include <cstdint>

namespace parhelion {

namespace {

constexpr int kNone = -1;

// Every pixel's index among the hits, or kNone.
Raster<int> indexHits(const HitMap& map, std::vector<std::size_t>& pixels) {
  Raster<int> index(map.width(), map.height(), kNone);
  for (std::size_t i = 0; i < index.size(); ++i) {
    if (!(map.hits()[i] > 0.0)) continue;
    index[i] = static_cast<int>(pixels.size());
    pixels.push_back(i);
  }
  return index;
}

// Rows from each pixel to the nearest hit of its column, kNone if the column has none.
Raster<int> columnDistances(const Raster<int>& index, bool wrapY) {
  const int height = index.height();
  Raster<int> distance(index.width(), height, kNone);
  forRows(index.width(), [&](int x) {
    // Downwards and upwards; round twice where the edges touch.
    for (const bool down : {true, false}) {
      int since = kNone;
      for (int i = wrapY ? -height : 0; i < height; ++i) {
        const int y = down ? (i + height) % height : height - 1 - (i + height) % height;
        if (since != kNone) ++since;
        if (index.at(x, y) != kNone) since = 0;
        int& d = distance.at(x, y);
        if (since != kNone && (d == kNone || since < d)) d = since;
      }
    }
  });
  return distance;
}

// Squared distance of a row's pixels from the nearest hit of a column: distance^2 + (x - column)^2.
struct Parabola {
  int column;
  std::int64_t distance;
};

// Where the parabola of a column farther right falls below: at num / den.
struct Crossing {
  std::int64_t num, den;
};

Crossing crossing(const Parabola& left, const Parabola& right) {
  const std::int64_t u = left.column, v = right.column;
  return {v * v - u * u + right.distance * right.distance - left.distance * left.distance, 2 * (v - u)};
}

bool isAfter(const Crossing& a, const Crossing& b) { return a.num * b.den > b.num * a.den; }

// The parabolas that are lowest somewhere, be it in a single point, from left to right. A torus is laid out far enough
// to both sides.
std::vector<Parabola> lowerEnvelope(const int* distances, int width, bool wrapX) {
  std::vector<Parabola> lowest;
  const int overlap = wrapX ? width / 2 : 0;
  for (int column = -overlap; column < width + overlap; ++column) {
    const int distance = distances[(column + width) % width];
    if (distance == kNone) continue;
    const Parabola next{column, distance};
    while (lowest.size() > 1) {
      const Parabola &last = lowest.back(), &before = lowest[lowest.size() - 2];
      if (!isAfter(crossing(before, last), crossing(last, next))) break;
      lowest.pop_back();
    }
    lowest.push_back(next);
  }
  return lowest;
}

// One row's search for the nearest.
struct RowSearch {
  const Raster<int>& index;
  int y;
  bool wrapX, wrapY;

  // The hits of a column that are `distance` rows away.
  void addColumn(int column, int distance, std::vector<int>& hits) const {
    const int height = index.height(), x = (column + index.width()) % index.width();
    const auto add = [&](int row) {
      if (wrapY) row = (row + height) % height;
      if (row >= 0 && row < height && index.at(x, row) != kNone) hits.push_back(index.at(x, row));
    };
    add(y - distance);
    // On a torus half a turn up and half a turn down meet.
    if (distance != 0 && !(wrapY && 2 * distance == height)) add(y + distance);
  }

  void addNearest(const std::vector<Parabola>& lowest, std::size_t& at, int x, std::vector<int>& hits) const {
    const auto crossesAt = [&](std::size_t i) {
      const Crossing c = crossing(lowest[i], lowest[i + 1]);
      return c.num - x * c.den;
    };
    while (at + 1 < lowest.size() && crossesAt(at) < 0) ++at;
    for (std::size_t i = at; i < lowest.size(); ++i) {
      const bool sameAsRight = wrapX && 2 * (x - lowest[i].column) == index.width();
      if (!sameAsRight) addColumn(lowest[i].column, static_cast<int>(lowest[i].distance), hits);
      if (i + 1 == lowest.size() || crossesAt(i) != 0) break;
    }
  }
};

}  // namespace

NearestHits::NearestHits(const HitMap& map) : width_(map.width()), height_(map.height()) {
  const Raster<int> index = indexHits(map, pixels_);
  const Raster<int> distances = columnDistances(index, map.wrapY);
  rows_.resize(static_cast<std::size_t>(height_));
  forRows(height_, [&](int y) {
    Row& row = rows_[static_cast<std::size_t>(y)];
    const std::vector<Parabola> lowest = lowerEnvelope(distances.row(y), width_, map.wrapX);
    const RowSearch search{index, y, map.wrapX, map.wrapY};
    std::size_t at = 0;
    for (int x = 0; x < width_; ++x) {
      row.first.push_back(row.hits.size());
      search.addNearest(lowest, at, x, row.hits);
    }
    row.first.push_back(row.hits.size());
  });
}

std::vector<double> NearestHits::cellSums(const Raster<double>& picture) const {
  std::vector<double> result(pixels_.size());
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      const std::span<const int> hits = of(x, y);
      for (const int hit : hits)
        result[static_cast<std::size_t>(hit)] += picture.at(x, y) / static_cast<double>(hits.size());
    }
  }
  return result;
}

Raster<double> NearestHits::interpolate(const std::vector<double>& values) const {
  Raster<double> picture(width_, height_);
  forRows(height_, [&](int y) {
    for (int x = 0; x < width_; ++x) {
      const std::span<const int> hits = of(x, y);
      double sum = 0.0;
      for (const int hit : hits) sum += values[static_cast<std::size_t>(hit)];
      if (!hits.empty()) picture.at(x, y) = sum / static_cast<double>(hits.size());
    }
  });
  return picture;
}

}  // namespace parhelion
