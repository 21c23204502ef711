// SPDX-License-Identifier: Apache-2.0
#pragma once

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

  double surface() const { return mesh->surfaceAcrossC() + mesh->surfaceAlongC() * stretch; }
  double volume() const { return mesh->volume() * stretch; }
};

/// Where light first meets a crystal.
struct EntryPoint {
  int face;    // index into the mesh's faces
  Vec3 point;  // crystal frame, on that face
};

}  // namespace parhelion
