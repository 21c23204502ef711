// SPDX-License-Identifier: Apache-2.0
#include "crystal/isometry.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

namespace parhelion {

namespace {

// Faces count as the same if neither their normals nor their distances from the centre (as a share of the crystal's
// radius) differ by more than rounding makes of them.
constexpr double kSamePlane = 1e-9;

using Edge = std::pair<Vec3, Vec3>;

/// The edges of a face, whole ones even where corners of other faces lie on them.
std::vector<Edge> edgesOf(const CrystalMesh& mesh, const Face& face) {
  std::vector<Edge> edges;
  for (const std::vector<int>& ring : outlinesOf(face)) {
    std::vector<Vec3> corners;
    for (std::size_t i = 0, n = ring.size(); i < n; ++i) {
      const Vec3 before = mesh.vertices()[ring[(i + n - 1) % n]], at = mesh.vertices()[ring[i]];
      const Vec3 along = glm::normalize(mesh.vertices()[ring[(i + 1) % n]] - before);
      if (glm::length(glm::cross(along, at - before)) > kSamePlane * mesh.radius()) corners.push_back(at);
    }
    for (std::size_t i = 0; i < corners.size(); ++i) edges.emplace_back(corners[i], corners[(i + 1) % corners.size()]);
  }
  return edges;
}

/// Whether an isometry takes some edges to others, in any order and sense.
bool takesEdges(const Isometry& isometry, const std::vector<Edge>& from, const std::vector<Edge>& to, double slack) {
  const auto isNear = [=](const Vec3& a, const Vec3& b) { return glm::length(a - b) < slack; };
  return from.size() == to.size() && std::ranges::all_of(from, [&](const Edge& edge) {
           const Vec3 a = isometry(edge.first), b = isometry(edge.second);
           return std::ranges::any_of(to, [&](const Edge& other) {
             return (isNear(a, other.first) && isNear(b, other.second)) ||
                    (isNear(a, other.second) && isNear(b, other.first));
           });
         });
}

}  // namespace

Vec3 Isometry::operator()(const Vec3& v) const {
  // Exact for all coordinates but the sine of 60 degrees.
  static const double kSine = 0.5 * std::sqrt(3.0);
  static const double kCosines[] = {1.0, 0.5, -0.5, -1.0, -0.5, 0.5};
  const double sines[] = {0.0, kSine, kSine, 0.0, -kSine, -kSine};
  const double y = flipsY ? -v.y : v.y, c = kCosines[sixths], s = sines[sixths];
  return {c * v.x - s * y, s * v.x + c * y, flipsZ ? -v.z : v.z};
}

std::array<Isometry, 24> hexagonalGroup() {
  std::array<Isometry, 24> group;
  for (int i = 0; i < 24; ++i) group[i] = {i % 6, i / 6 % 2 == 1, i / 12 == 1};
  return group;
}

std::optional<std::vector<int>> faceImages(const CrystalMesh& mesh, const Isometry& isometry) {
  // Planes do not say what of them is face where crystals are not convex, nor which of two faces in one plane.
  std::vector<std::vector<Edge>> edges;
  if (!mesh.isConvex())
    for (const Face& face : mesh.faces()) edges.push_back(edgesOf(mesh, face));
  const auto isAt = [&](const Face& other, const Face& face) {
    const auto edgesAt = [&](const Face& f) -> const std::vector<Edge>& { return edges[&f - mesh.faces().data()]; };
    return mesh.isConvex() || takesEdges(isometry, edgesAt(face), edgesAt(other), kSamePlane * mesh.radius());
  };
  std::vector<int> images;
  std::vector<bool> taken(mesh.faces().size(), false);
  for (const Face& face : mesh.faces()) {
    const Vec3 normal = isometry(face.normal);
    const auto image = std::ranges::find_if(mesh.faces(), [&](const Face& other) {
      return glm::length(other.normal - normal) < kSamePlane &&
             std::abs(other.offset - face.offset) < kSamePlane * mesh.radius() &&
             std::abs(other.area - face.area) < kSamePlane * mesh.radius() * mesh.radius() && isAt(other, face);
    });
    if (image == mesh.faces().end()) return std::nullopt;
    const auto index = image - mesh.faces().begin();
    if (taken[index]) return std::nullopt;
    taken[index] = true;
    images.push_back(static_cast<int>(index));
  }
  return images;
}

}  // namespace parhelion
