// SPDX-License-Identifier: Apache-2.0
#include "crystal/isometry.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include <glm/geometric.hpp>

namespace parhelion {

namespace {

// Faces count as the same if neither their normals nor their distances from the centre (as a share of the crystal's
// radius) differ by more than rounding makes of them.
constexpr double kSamePlane = 1e-9;

/// Where an isometry takes the vertices of a mesh; none where there is no vertex.
std::optional<std::vector<int>> vertexImages(const CrystalMesh& mesh, const Isometry& isometry) {
  std::vector<int> images;
  for (const Vec3& vertex : mesh.vertices()) {
    const Vec3 image = isometry(vertex);
    const auto found = std::ranges::find_if(
        mesh.vertices(), [&](const Vec3& v) { return glm::length(v - image) < kSamePlane * mesh.radius(); });
    if (found == mesh.vertices().end()) return std::nullopt;
    images.push_back(static_cast<int>(found - mesh.vertices().begin()));
  }
  return images;
}

/// Whether an isometry takes the edges of all faces to those of their images: planes do not say what of them is face
/// where crystals are not convex.
bool keepsEdges(const CrystalMesh& mesh, const Isometry& isometry, const std::vector<int>& images) {
  const auto vertices = vertexImages(mesh, isometry);
  if (!vertices) return false;
  const auto edgesOf = [](const Face& face, const auto& place) {
    std::set<std::pair<int, int>> edges;
    for (const std::vector<int>& ring : outlinesOf(face))
      for (std::size_t i = 0; i < ring.size(); ++i)
        edges.insert(std::minmax({place(ring[i]), place(ring[(i + 1) % ring.size()])}));
    return edges;
  };
  for (std::size_t f = 0; f < images.size(); ++f)
    if (edgesOf(mesh.faces()[f], [&](int v) { return (*vertices)[static_cast<std::size_t>(v)]; }) !=
        edgesOf(mesh.faces()[static_cast<std::size_t>(images[f])], [](int v) { return v; }))
      return false;
  return true;
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
  std::vector<int> images;
  std::vector<bool> taken(mesh.faces().size(), false);
  for (const Face& face : mesh.faces()) {
    const Vec3 normal = isometry(face.normal);
    const auto image = std::ranges::find_if(mesh.faces(), [&](const Face& other) {
      return glm::length(other.normal - normal) < kSamePlane &&
             std::abs(other.offset - face.offset) < kSamePlane * mesh.radius() &&
             std::abs(other.area - face.area) < kSamePlane * mesh.radius() * mesh.radius();
    });
    if (image == mesh.faces().end()) return std::nullopt;
    const auto index = image - mesh.faces().begin();
    if (taken[index]) return std::nullopt;
    taken[index] = true;
    images.push_back(static_cast<int>(index));
  }
  if (!mesh.isConvex() && !keepsEdges(mesh, isometry, images)) return std::nullopt;
  return images;
}

}  // namespace parhelion
