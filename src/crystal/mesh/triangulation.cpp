// SPDX-License-Identifier: Apache-2.0
#include "crystal/mesh/triangulation.h"

#include <cmath>

#include <glm/geometric.hpp>

namespace parhelion {

namespace {

// A face with less area than this share of the square of the mesh's size has none.
constexpr double kNoArea = 1e-12;

/// One polygon of which ears are cut off.
class Ears {
 public:
  Ears(const ObjMesh& mesh, int polygon, const Vec3& normal)
      : mesh_(mesh), polygon_(polygon), normal_(normal), ring_(of().corners) {}

  void cut(std::vector<MeshTriangle>& triangles) {
    std::size_t at = 0, tried = 0;
    while (ring_.size() > 3) {
      if (tried > ring_.size()) throw ObjError(of().line, "this face crosses itself, or its corners lie in one line");
      at %= ring_.size();
      if (!isEar(at)) {
        ++at;
        ++tried;
        continue;
      }
      add(at, triangles);
      ring_.erase(ring_.begin() + static_cast<std::ptrdiff_t>(at));
      tried = 0;
    }
    add(1, triangles);
  }

 private:
  const ObjPolygon& of() const { return mesh_.polygons[static_cast<std::size_t>(polygon_)]; }
  int corner(std::size_t i) const { return ring_[i % ring_.size()]; }
  Vec3 place(std::size_t i) const { return mesh_.vertices[static_cast<std::size_t>(corner(i))]; }
  double turn(const Vec3& a, const Vec3& b, const Vec3& c) const { return glm::dot(normal_, glm::cross(b - a, c - a)); }

  /// Whether corner i turns left and the triangle with its neighbours holds no other corner.
  bool isEar(std::size_t i) const {
    const std::size_t n = ring_.size(), before = i + n - 1;
    const Vec3 a = place(before), b = place(i), c = place(i + 1);
    if (!(turn(a, b, c) > 1e-12 * glm::dot(c - a, c - a))) return false;
    for (std::size_t k = i + 2; k < before; ++k) {
      if (corner(k) == corner(before) || corner(k) == corner(i) || corner(k) == corner(i + 1)) continue;
      const Vec3 v = place(k);
      if (turn(a, b, v) >= 0.0 && turn(b, c, v) >= 0.0 && turn(c, a, v) >= 0.0) return false;
    }
    return true;
  }

  void add(std::size_t i, std::vector<MeshTriangle>& triangles) const {
    const std::size_t before = i + ring_.size() - 1;
    if (!(turn(place(before), place(i), place(i + 1)) > 0.0))
      throw ObjError(of().line, "this face crosses itself, or its corners lie in one line");
    triangles.push_back({{corner(before), corner(i), corner(i + 1)}, polygon_});
  }

  const ObjMesh& mesh_;
  int polygon_;
  Vec3 normal_;
  std::vector<int> ring_;
};

}  // namespace

Vec3 areaVector(const ObjMesh& mesh, const ObjPolygon& polygon) {
  const auto place = [&](std::size_t i) { return mesh.vertices[static_cast<std::size_t>(polygon.corners[i])]; };
  Vec3 area(0.0);
  for (std::size_t i = 1; i + 1 < polygon.corners.size(); ++i)
    area += 0.5 * glm::cross(place(i) - place(0), place(i + 1) - place(0));
  return area;
}

std::vector<MeshTriangle> triangulate(const ObjMesh& mesh) {
  const double size = sizeOf(mesh.vertices);
  std::vector<MeshTriangle> triangles;
  for (int p = 0; p < static_cast<int>(mesh.polygons.size()); ++p) {
    const ObjPolygon& polygon = mesh.polygons[static_cast<std::size_t>(p)];
    const Vec3 area = areaVector(mesh, polygon);
    const double length = glm::length(area);
    if (!(length > kNoArea * size * size)) throw ObjError(polygon.line, "this face has no area");
    const Vec3 normal = area / length, origin = mesh.vertices[static_cast<std::size_t>(polygon.corners[0])];
    for (const int corner : polygon.corners)
      if (std::abs(glm::dot(normal, mesh.vertices[static_cast<std::size_t>(corner)] - origin)) > kFlat * size)
        throw ObjError(polygon.line, "this face is not planar");
    Ears(mesh, p, normal).cut(triangles);
  }
  return triangles;
}

}  // namespace parhelion
