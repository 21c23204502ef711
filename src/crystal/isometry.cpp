// SPDX-License-Identifier: Apache-2.0
#include "crystal/isometry.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace parhelion {

namespace {

// Faces count as the same if neither their normals nor their distances from the centre (as a share of the crystal's
// radius) differ by more than rounding makes of them.
constexpr double kSamePlane = 1e-9;

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
  return images;
}

}  // namespace parhelion
