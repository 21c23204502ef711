// SPDX-License-Identifier: Apache-2.0
#include "optics/caustic.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include <glm/geometric.hpp>

namespace parhelion {
namespace {

constexpr double kDifference = 1e-6;  // rad, for derivatives: a fold is off by about that
constexpr int kHalvings = 26;         // of a step, to where the map folds

// Neighbours on a fold that lie farther apart on the sky belong to two folds, rad.
constexpr double kLongestPiece = radians(6.0);

/// Follows the zeros of the map's determinant through the cells of a grid (marching squares).
class FoldFinder {
 public:
  FoldFinder(const AnglesToSky& map, const AngleSteps& first, const AngleSteps& second)
      : map_(map), first_(first), second_(second) {
    values_.reserve(static_cast<std::size_t>(columns()) * static_cast<std::size_t>(second.steps + 1));
    for (int j = 0; j <= second.steps; ++j)
      for (int i = 0; i <= first.steps; ++i) values_.push_back(area(at(i, j)));
  }

  std::vector<SkyLine> find() {
    for (int j = 0; j < second_.steps; ++j)
      for (int i = 0; i < first_.steps; ++i) crossCell(i, j);
    return chains();
  }

 private:
  /// An edge of the grid: from (i, j) one step along the first angle, or along the second.
  struct Edge {
    int i, j;
    bool alongSecond;
    auto operator<=>(const Edge&) const = default;
  };
  struct Crossing {
    Vec3 toSky;
    std::vector<Edge> next;
    bool used = false;
  };

  int columns() const { return first_.steps + 1; }
  Vec2 at(int i, int j) const {
    return {first_.from + (first_.to - first_.from) * i / first_.steps,
            second_.from + (second_.to - second_.from) * j / second_.steps};
  }
  const std::optional<double>& value(int i, int j) const {
    return values_[static_cast<std::size_t>(j) * static_cast<std::size_t>(columns()) + static_cast<std::size_t>(i)];
  }

  /// The area of sky that a small square of angles takes, with a sign.
  std::optional<double> area(const Vec2& angles) const {
    const auto seen = map_(angles.x, angles.y);
    if (!seen) return std::nullopt;
    const auto right = map_(angles.x + kDifference, angles.y), up = map_(angles.x, angles.y + kDifference);
    if (!right || !up) return std::nullopt;
    return glm::dot(*seen, glm::cross(*right - *seen, *up - *seen));
  }

  /// Where on an edge the determinant is 0.
  bool cross(const Edge& edge) {
    if (crossings_.contains(edge)) return true;
    const int i = edge.i + !edge.alongSecond, j = edge.j + edge.alongSecond;
    const std::optional<double>&a = value(edge.i, edge.j), &b = value(i, j);
    if (!a || !b || (*a < 0.0) == (*b < 0.0)) return false;
    Vec2 low = at(edge.i, edge.j), high = at(i, j);
    for (int k = 0; k < kHalvings; ++k) {
      const Vec2 middle = 0.5 * (low + high);
      const std::optional<double> m = area(middle);
      if (!m) return false;
      ((*m < 0.0) == (*a < 0.0) ? low : high) = middle;
    }
    const auto seen = map_(low.x, low.y);
    if (seen) crossings_[edge] = {*seen, {}};
    return seen.has_value();
  }

  void crossCell(int i, int j) {
    std::vector<Edge> crossed;
    for (const Edge& edge : {Edge{i, j, false}, Edge{i + 1, j, true}, Edge{i, j + 1, false}, Edge{i, j, true}})
      if (cross(edge)) crossed.push_back(edge);
    for (std::size_t k = 1; k < crossed.size(); k += 2) {
      Crossing &a = crossings_[crossed[k - 1]], &b = crossings_[crossed[k]];
      if (glm::length(a.toSky - b.toSky) > kLongestPiece) continue;
      a.next.push_back(crossed[k]);
      b.next.push_back(crossed[k - 1]);
    }
  }

  /// The line from an end of a fold, or round a closed one.
  SkyLine walk(Edge edge) {
    SkyLine line;
    for (bool more = true; more;) {
      Crossing& here = crossings_[edge];
      here.used = true;
      append(line, here.toSky);
      const auto next =
          std::find_if(here.next.begin(), here.next.end(), [&](const Edge& e) { return !crossings_[e].used; });
      more = next != here.next.end();
      if (more) {
        edge = *next;
      } else if (line.size() > 2) {
        for (const Edge& e : here.next)  // closed
          if (here.next.size() == 2 && crossings_[e].toSky == line.front()) append(line, line.front());
      }
    }
    return line;
  }

  /// In steps of the lines that followLocus() gives.
  static void append(SkyLine& line, const Vec3& to) {
    if (line.empty()) return line.push_back(to);
    const Vec3 from = line.back();
    const int steps = std::max(1, static_cast<int>(std::ceil(glm::length(to - from) / kSkyLineStep)));
    for (int k = 1; k <= steps; ++k)
      line.push_back(k == steps ? to : glm::normalize(from + (to - from) * (static_cast<double>(k) / steps)));
  }

  std::vector<SkyLine> chains() {
    std::vector<SkyLine> lines;
    for (const bool fromEnds : {true, false})
      for (auto& [edge, crossing] : crossings_) {
        if (crossing.used || (fromEnds && crossing.next.size() != 1)) continue;
        SkyLine line = walk(edge);
        if (line.size() > 1) lines.push_back(std::move(line));
      }
    return lines;
  }

  const AnglesToSky& map_;
  AngleSteps first_, second_;
  std::vector<std::optional<double>> values_;
  std::map<Edge, Crossing> crossings_;
};

}  // namespace

std::vector<SkyLine> foldsOf(const AnglesToSky& map, const AngleSteps& first, const AngleSteps& second) {
  return FoldFinder(map, first, second).find();
}

}  // namespace parhelion
