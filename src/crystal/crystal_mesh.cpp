// SPDX-License-Identifier: Apache-2.0
#include "crystal/crystal_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

#include <glm/geometric.hpp>

namespace parhelion {

namespace {

// A vertex this far off a plane, as a share of the crystal's radius, still lies in it: a thousand times what building a
// crystal in double precision leaves.
constexpr double kPlanarity = 1e-12;

[[noreturn]] void reject(int faceNumber, const std::string& why) {
  throw std::invalid_argument("crystal face " + std::to_string(faceNumber) + " " + why);
}

}  // namespace

std::vector<std::vector<int>> openRings(const std::set<std::pair<int, int>>& edges) {
  std::multimap<int, int> next;
  for (const auto& [a, b] : edges)
    if (!edges.contains({b, a})) next.emplace(a, b);
  std::vector<std::vector<int>> rings;
  while (!next.empty()) {
    rings.emplace_back();
    for (auto edge = next.begin(); edge != next.end();) {
      const auto [from, to] = *edge;
      rings.back().push_back(from);
      next.erase(edge);
      edge = next.find(to);
    }
  }
  return rings;
}

std::vector<std::vector<int>> outlinesOf(const Face& face) {
  if (face.triangles.empty()) return {face.vertices};
  std::set<std::pair<int, int>> edges;
  for (const auto& [a, b, c] : face.triangles) edges.insert({{a, b}, {b, c}, {c, a}});
  return openRings(edges);
}

CrystalMesh::CrystalMesh(std::vector<Vec3> vertices, const std::vector<FaceOutline>& outlines)
    : vertices_(std::move(vertices)) {
  if (outlines.size() > kMaxFaces) throw std::invalid_argument("a crystal may have at most 32 faces");
  for (const Vec3& v : vertices_) {
    if (!std::isfinite(v.x + v.y + v.z)) throw std::invalid_argument("a crystal vertex is not finite");
    radius_ = std::max(radius_, glm::length(v));
  }
  for (const FaceOutline& outline : outlines) faces_.push_back(makeFace(outline));
  checkClosed();
  addUp();
  for (const Face& face : faces_)
    for (const Vec3& v : vertices_) convex_ &= glm::dot(face.normal, v) <= face.offset + kPlanarity * radius_;
}

CrystalMesh::CrystalMesh(std::vector<Vec3> vertices, std::span<const FaceTriangles> faces)
    : vertices_(std::move(vertices)), convex_(false) {
  for (const Vec3& v : vertices_) radius_ = std::max(radius_, glm::length(v));
  for (const auto& [number, normal, offset, triangles] : faces) {
    double area = 0.0;
    for (const auto& [a, b, c] : triangles)
      area += 0.5 * glm::length(glm::cross(vertices_[b] - vertices_[a], vertices_[c] - vertices_[a]));
    faces_.push_back({number, {}, normal, offset, area, {}, triangles});
  }
  addUp();
}

/// Surface and volume from the faces.
void CrystalMesh::addUp() {
  for (const Face& face : faces_) {
    (face.normal.z == 0.0 ? surfaceAlongC_ : surfaceAcrossC_) += face.area;
    volume_ += face.area * face.offset / 3.0;
    const double alongC = std::abs(face.normal.z);
    prismatic_ &= alongC == 0.0 || alongC == 1.0;
  }
  if (!(volume_ > 0.0)) throw std::invalid_argument("the crystal's faces are turned inside out");
}

Face CrystalMesh::makeFace(const FaceOutline& outline) const {
  const auto& ring = outline.vertices;
  if (ring.empty() && outline.normal) return {outline.number, {}, *outline.normal, outline.offset, 0.0, {}};
  if (ring.size() < 3) reject(outline.number, "has fewer than three vertices");
  for (const int v : ring)
    if (v < 0 || v >= static_cast<int>(vertices_.size())) reject(outline.number, "names a vertex that does not exist");

  // Twice the area vector, from the first vertex so that a small face far from the origin keeps its digits.
  const Vec3 origin = vertices_[ring[0]];
  Vec3 area(0.0);
  std::vector<double> fan;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    const Vec3 triangle = glm::cross(vertices_[ring[i]] - origin, vertices_[ring[i + 1]] - origin);
    area += triangle;
    fan.push_back(0.5 * glm::length(triangle));
  }
  const double length = glm::length(area);
  if (!(length > 0.0)) reject(outline.number, "has no area");

  Vec3 normal = outline.normal.value_or(area / length);
  // Rounding must not tilt faces that are parallel or perpendicular to c.
  if (std::abs(normal.z) < kPlanarity) normal = glm::normalize(Vec3(normal.x, normal.y, 0.0));
  if (std::hypot(normal.x, normal.y) < kPlanarity) normal = Vec3(0.0, 0.0, std::copysign(1.0, normal.z));

  const double offset = glm::dot(normal, origin);
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec3 a = vertices_[ring[i]], b = vertices_[ring[(i + 1) % ring.size()]];
    const Vec3 c = vertices_[ring[(i + 2) % ring.size()]];
    if (std::abs(glm::dot(normal, a) - offset) > kPlanarity * radius_) reject(outline.number, "is not planar");
    if (glm::dot(glm::cross(b - a, c - b), normal) < -kPlanarity * radius_ * radius_)
      reject(outline.number, "is not convex");
  }
  return {outline.number, ring, normal, offset, 0.5 * length, std::move(fan)};
}

void CrystalMesh::checkClosed() const {
  std::map<std::pair<int, int>, int> uses;
  for (const Face& face : faces_)
    for (std::size_t i = 0; i < face.vertices.size(); ++i)
      ++uses[{face.vertices[i], face.vertices[(i + 1) % face.vertices.size()]}];
  for (const auto& [edge, count] : uses) {
    const auto back = uses.find({edge.second, edge.first});
    if (count != 1 || back == uses.end())
      throw std::invalid_argument("the crystal is not closed: an edge is not shared by exactly two faces");
  }
}

}  // namespace parhelion
