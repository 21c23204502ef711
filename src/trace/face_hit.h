// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "crystal/crystal.h"
#include "crystal/face_table.h"

namespace parhelion {

/// Where a ray inside a crystal meets its surface.
struct FaceHit {
  int face;         // index into the mesh's faces
  double distance;  // along the ray's direction, >= 0, crystal units
  double cosine;    // of the ray's direction and the face's outward normal, > 0
  bool rescued;     // the engine found no face and the planes decided instead
};

inline constexpr int kNoFace = -1;

/// The next face of a convex crystal met from inside by the ray (`point`, `lightDir`: unit, crystal frame), by distance
/// to the faces' planes in double precision. `leftFace`, the face the ray starts on, is left out by index. Empty only
/// when `lightDir` is not finite.
std::optional<FaceHit> nextFaceByPlanes(const Crystal& crystal, const Vec3& point, const Vec3& lightDir, int leftFace);

/// What intersectors need to know of the mesh that they find the faces of for many rays at a time.
struct MeshTables {
  const CrystalMesh& mesh;
  const FaceTable& faces;
};

}  // namespace parhelion
