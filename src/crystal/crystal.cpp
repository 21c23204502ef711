// SPDX-License-Identifier: Apache-2.0
#include "crystal/crystal.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace parhelion {

namespace {

double shadowOf(const Crystal& crystal, int face, const Vec3& lightDir) {
  const double cosine = -glm::dot(crystal.mesh->faces()[face].normal, lightDir);
  return cosine > 0.0 ? cosine * crystal.area(face) : 0.0;
}

/// A uniform point of a convex face: pick a triangle of its fan by area, then a point in the triangle.
Vec3 pointOnFace(const CrystalMesh& mesh, const Face& face, double u1, double u2) {
  const Vec3 a = mesh.vertices()[face.vertices[0]];
  double left = u1 * face.area;
  const int triangles = static_cast<int>(face.vertices.size()) - 2;
  for (int i = 0; i < triangles; ++i) {
    const Vec3 ab = mesh.vertices()[face.vertices[i + 1]] - a, ac = mesh.vertices()[face.vertices[i + 2]] - a;
    const double area = 0.5 * glm::length(glm::cross(ab, ac));
    if (left > area && i + 1 < triangles) {
      left -= area;
      continue;
    }
    // What is left of u1 is uniform again; the square root makes the triangle uniform.
    const double s = std::sqrt(std::min(1.0, left / area));
    return a + (s * (1.0 - u2)) * ab + (s * u2) * ac;
  }
  return a;
}

}  // namespace

double Crystal::surface() const {
  double sum = 0.0;
  for (int face = 0; face < static_cast<int>(mesh->faces().size()); ++face) sum += area(face);
  return sum;
}

double projectedArea(const Crystal& crystal, const Vec3& lightDirCrystal) {
  double sum = 0.0;
  for (int face = 0; face < static_cast<int>(crystal.mesh->faces().size()); ++face)
    sum += shadowOf(crystal, face, lightDirCrystal);
  return sum;
}

EntryPoint sampleEntry(const Crystal& crystal, const Vec3& lightDirCrystal, double u1, double u2, double u3) {
  const int faces = static_cast<int>(crystal.mesh->faces().size());
  double left = u1 * projectedArea(crystal, lightDirCrystal);
  int lit = 0;
  for (int face = 0; face < faces; ++face) {
    const double shadow = shadowOf(crystal, face, lightDirCrystal);
    if (shadow == 0.0) continue;
    lit = face;
    if (left < shadow) break;
    left -= shadow;
  }
  Vec3 point = pointOnFace(*crystal.mesh, crystal.mesh->faces()[lit], u2, u3);
  point.z *= crystal.stretch;
  return {lit, point};
}

}  // namespace parhelion
