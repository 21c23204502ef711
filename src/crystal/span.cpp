// SPDX-License-Identifier: Apache-2.0
#include "crystal/span.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace parhelion {

namespace {

/// Second moments of an area about its middle, in a frame of its plane, over the area.
struct Moments {
  double area = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;

  void add(const Vec3 (&corners)[3], const Vec3& u, const Vec3& v) {
    double sumX = 0.0, sumY = 0.0, ownXx = 0.0, ownXy = 0.0, ownYy = 0.0;
    for (const Vec3& corner : corners) {
      const double a = glm::dot(corner, u), b = glm::dot(corner, v);
      sumX += a;
      sumY += b;
      ownXx += a * a;
      ownXy += a * b;
      ownYy += b * b;
    }
    const double own = 0.5 * glm::length(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
    area += own;
    x += own * sumX / 3.0;
    y += own * sumY / 3.0;
    xx += own * (ownXx + sumX * sumX) / 12.0;
    xy += own * (ownXy + sumX * sumY) / 12.0;
    yy += own * (ownYy + sumY * sumY) / 12.0;
  }
};

}  // namespace

CrystalSpan::CrystalSpan(const CrystalMesh& mesh) {
  const std::vector<Vec3>& corners = mesh.vertices();
  const bool isPrismatic = mesh.isPrismatic();
  for (std::size_t i = 0; i < corners.size(); ++i)
    for (std::size_t j = i + 1; j < corners.size(); ++j) {
      const Vec3 d = corners[i] - corners[j];
      across_ = std::max(across_, d.x * d.x + d.y * d.y + (isPrismatic ? 0.0 : d.z * d.z));
      if (isPrismatic) along_ = std::max(along_, std::abs(d.z));
    }
  across_ = std::sqrt(across_);
}

double CrystalSpan::at(double stretch) const {
  return std::sqrt(across_ * across_ + stretch * stretch * along_ * along_);
}

FaceRectangle rectangleOf(const CrystalMesh& mesh, int face) {
  const Face& own = mesh.faces()[static_cast<std::size_t>(face)];
  const Vec3 level = glm::cross(Vec3(0.0, 0.0, 1.0), own.normal);
  const Vec3 u = glm::length(level) > 1e-9 ? glm::normalize(level) : Vec3(1.0, 0.0, 0.0), v = glm::cross(own.normal, u);
  const Vec3 origin = own.vertices.empty() ? Vec3(0.0) : mesh.vertices()[static_cast<std::size_t>(own.vertices[0])];
  const auto at = [&](int vertex) { return mesh.vertices()[static_cast<std::size_t>(vertex)] - origin; };
  Moments m;
  for (std::size_t i = 0; i + 2 < own.vertices.size(); ++i)
    m.add({at(own.vertices[0]), at(own.vertices[i + 1]), at(own.vertices[i + 2])}, u, v);
  for (const auto& [a, b, c] : own.triangles) m.add({at(a), at(b), at(c)}, u, v);
  if (!(m.area > 0.0)) return {Vec3(0.0), Vec3(0.0)};
  // The root of twelve times the moments: a rectangle of sides a and b has a^2 / 12 and b^2 / 12.
  const double x = m.x / m.area, y = m.y / m.area;
  const double xx = 12.0 * (m.xx / m.area - x * x), xy = 12.0 * (m.xy / m.area - x * y),
               yy = 12.0 * (m.yy / m.area - y * y);
  const double root = std::sqrt(std::max(0.0, xx * yy - xy * xy)), per = 1.0 / std::sqrt(xx + yy + 2.0 * root);
  return {per * ((xx + root) * u + xy * v), per * (xy * u + (yy + root) * v)};
}

}  // namespace parhelion
