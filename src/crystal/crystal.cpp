// SPDX-License-Identifier: Apache-2.0
#include "crystal/crystal.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace parhelion {

namespace {

/// A uniform point of a convex face: pick a triangle of its fan by area, then a point in the triangle.
Vec3 pointOnFace(const CrystalMesh& mesh, const Face& face, double u1, double u2) {
  const Vec3 a = mesh.vertices()[face.vertices[0]];
  double left = u1 * face.area;
  const int triangles = static_cast<int>(face.fan.size());
  for (int i = 0; i < triangles; ++i) {
    const double area = face.fan[i];
    if (left > area && i + 1 < triangles) {
      left -= area;
      continue;
    }
    const Vec3 ab = mesh.vertices()[face.vertices[i + 1]] - a, ac = mesh.vertices()[face.vertices[i + 2]] - a;
    // What is left of u1 is uniform again; the square root makes the triangle uniform.
    const double s = std::sqrt(std::min(1.0, left / area));
    return a + (s * (1.0 - u2)) * ab + (s * u2) * ac;
  }
  return a;
}

}  // namespace

Shadows shadowsOf(const Crystal& crystal, const Vec3& lightDirCrystal) {
  Shadows shadows;
  shadows.total = 0.0;
  const auto& faces = crystal.mesh->faces();
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const double cosine = -glm::dot(faces[i].normal, lightDirCrystal);
    const double shadow = std::max(0.0, cosine) * crystal.area(static_cast<int>(i));
    shadows.face[i] = shadow;
    shadows.total += shadow;
  }
  return shadows;
}

double projectedArea(const Crystal& crystal, const Vec3& lightDirCrystal) {
  return shadowsOf(crystal, lightDirCrystal).total;
}

EntryPoint sampleEntry(const Crystal& crystal, const Vec3& lightDirCrystal, double u1, double u2, double u3) {
  return sampleEntry(crystal, shadowsOf(crystal, lightDirCrystal), u1, u2, u3);
}

EntryPoint sampleEntry(const Crystal& crystal, const Shadows& shadows, double u1, double u2, double u3) {
  const int faces = static_cast<int>(crystal.mesh->faces().size());
  double left = u1 * shadows.total;
  int lit = 0;
  for (int face = 0; face < faces; ++face) {
    const double shadow = shadows.face[face];
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
