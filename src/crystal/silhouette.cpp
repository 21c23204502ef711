// SPDX-License-Identifier: Apache-2.0
#include "crystal/silhouette.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

namespace parhelion {

namespace {

// Lines across the shadow, at least.
constexpr int kLines = 64;
// The length of lines changes steadily between corners. Where a crystal has many of them, corners that are closer than
// a share of the shadow's height are taken as one; else, those that only rounding tells apart.
constexpr std::size_t kManyCorners = 256;
constexpr double kCloseOfMany = 1.0 / (16 * kLines), kCloseOfFew = 1e-13;

struct PlanePoint {
  double x, y;
};

/// The shadow of a triangle, its corners from the lowest to the highest.
struct ShadowTriangle {
  PlanePoint low, middle, high;

  /// Where a line of that height goes through it, from left to right.
  std::pair<double, double> across(double y) const {
    const auto at = [y](const PlanePoint& a, const PlanePoint& b) {
      return b.y > a.y ? a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y)) : a.x;
    };
    return std::minmax({at(low, high), y < middle.y ? at(low, middle) : at(middle, high)});
  }
};

/// A plane across the light whose axes are parallel to no edge of a crystal as crystals are.
class ShadowPlane {
 public:
  explicit ShadowPlane(const Vec3& lightDir) {
    const Vec3 odd = glm::normalize(Vec3(0.3796, 0.6180, 0.6889));
    const Vec3 other = std::abs(glm::dot(odd, lightDir)) < 0.9 ? odd : Vec3(odd.z, -odd.x, odd.y);
    x_ = glm::normalize(glm::cross(lightDir, other));
    y_ = glm::cross(lightDir, x_);
  }

  PlanePoint at(const Vec3& point) const { return {glm::dot(x_, point), glm::dot(y_, point)}; }

 private:
  Vec3 x_, y_;
};

/// The shadows of all that faces the light, the lowest first: together they are the crystal's.
std::vector<ShadowTriangle> litTriangles(const CrystalMesh& mesh, const Vec3& lightDir,
                                         const std::vector<PlanePoint>& shadows) {
  std::vector<ShadowTriangle> all;
  const auto add = [&](int a, int b, int c) {
    PlanePoint corners[] = {shadows[a], shadows[b], shadows[c]};
    std::ranges::sort(corners, {}, &PlanePoint::y);
    all.push_back({corners[0], corners[1], corners[2]});
  };
  for (const Face& face : mesh.faces()) {
    if (!(glm::dot(face.normal, lightDir) < 0.0)) continue;
    for (std::size_t i = 1; i + 1 < face.vertices.size(); ++i)
      add(face.vertices[0], face.vertices[i], face.vertices[i + 1]);
    for (const auto& [a, b, c] : face.triangles) add(a, b, c);
  }
  std::ranges::sort(all, {}, [](const ShadowTriangle& t) { return t.low.y; });
  return all;
}

/// The length of the union of some intervals.
double lengthOf(std::vector<std::pair<double, double>>& intervals) {
  std::ranges::sort(intervals);
  double length = 0.0, end = -HUGE_VAL;
  for (const auto& [from, to] : intervals) {
    if (to <= end) continue;
    length += to - std::max(from, end);
    end = to;
  }
  return length;
}

/// The heights between which the length of lines across the shadow changes steadily.
std::vector<double> cornerHeights(const std::vector<PlanePoint>& shadows) {
  std::vector<double> all;
  for (const PlanePoint& p : shadows) all.push_back(p.y);
  std::ranges::sort(all);
  const double share = all.size() > kManyCorners ? kCloseOfMany : kCloseOfFew;
  const double top = all.back(), closest = share * (top - all.front());
  std::vector<double> apart(1, all.front());
  for (const double y : all)
    if (y > apart.back() + closest) apart.push_back(y);
  apart.back() = top;
  return apart;
}

}  // namespace

double silhouetteOf(const CrystalMesh& mesh, const Vec3& lightDir) {
  const ShadowPlane plane(lightDir);
  std::vector<PlanePoint> shadows;
  for (const Vec3& vertex : mesh.vertices()) shadows.push_back(plane.at(vertex));
  const std::vector<ShadowTriangle> triangles = litTriangles(mesh, lightDir, shadows);
  const std::vector<double> heights = cornerHeights(shadows);
  const double most = (heights.back() - heights.front()) / kLines;
  std::vector<const ShadowTriangle*> met;  // that reach the line
  std::vector<std::pair<double, double>> intervals;
  std::size_t next = 0;
  double area = 0.0;
  for (std::size_t strip = 0; strip + 1 < heights.size(); ++strip) {
    const int lines = std::max(1, static_cast<int>(std::ceil((heights[strip + 1] - heights[strip]) / most)));
    const double step = (heights[strip + 1] - heights[strip]) / lines;
    for (int line = 0; line < lines; ++line) {
      const double y = heights[strip] + (line + 0.5) * step;
      while (next < triangles.size() && triangles[next].low.y <= y) met.push_back(&triangles[next++]);
      std::erase_if(met, [y](const ShadowTriangle* triangle) { return triangle->high.y < y; });
      intervals.clear();
      for (const ShadowTriangle* triangle : met) intervals.push_back(triangle->across(y));
      area += step * lengthOf(intervals);
    }
  }
  return area;
}

}  // namespace parhelion
