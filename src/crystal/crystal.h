// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "crystal/crystal_mesh.h"

namespace parhelion {

/// One crystal of the cloud: a mesh, stretched along c by `stretch`. Only prismatic meshes may be stretched, so that
/// face normals stay as they are and one mesh serves every aspect ratio.
struct Crystal {
  const CrystalMesh* mesh;
  double stretch = 1.0;

  /// normal . point for the points of face `face` (an index into mesh->faces()).
  double offset(int face) const {
    const Face& f = mesh->faces()[face];
    return f.normal.z == 0.0 ? f.offset : f.offset * stretch;
  }

  double area(int face) const {
    const Face& f = mesh->faces()[face];
    return f.normal.z == 0.0 ? f.area * stretch : f.area;
  }

  double surface() const { return mesh->surfaceAcrossC() + mesh->surfaceAlongC() * stretch; }
  double volume() const { return mesh->volume() * stretch; }
};

/// Where light first meets a crystal.
struct EntryPoint {
  int face;    // index into the mesh's faces
  Vec3 point;  // crystal frame, on that face
};

/// The shadows that a convex crystal's lit faces cast on a plane across the light.
struct Shadows {
  std::array<double, kMaxFaces> face;  // as many as the mesh has; 0 for faces in the dark
  double total;
};
Shadows shadowsOf(const Crystal& crystal, const Vec3& lightDirCrystal);

/// The area of a convex crystal's shadow on a plane across `lightDirCrystal` (unit).
double projectedArea(const Crystal& crystal, const Vec3& lightDirCrystal);

/// A point of the lit side of a convex crystal, uniform over its shadow, for three numbers in (0, 1).
EntryPoint sampleEntry(const Crystal& crystal, const Shadows& shadows, double u1, double u2, double u3);
EntryPoint sampleEntry(const Crystal& crystal, const Vec3& lightDirCrystal, double u1, double u2, double u3);

}  // namespace parhelion
