// SPDX-License-Identifier: Apache-2.0
#include "trace/face_hit.h"

#include <algorithm>

#include <glm/geometric.hpp>

namespace parhelion {

std::optional<FaceHit> nextFaceByPlanes(const Crystal& crystal, const Vec3& point, const Vec3& lightDir, int leftFace) {
  std::optional<FaceHit> nearest;
  const auto& faces = crystal.mesh->faces();
  for (int face = 0; face < static_cast<int>(faces.size()); ++face) {
    const double approach = glm::dot(faces[face].normal, lightDir);
    if (face == leftFace || !(approach > 0.0) || faces[face].area == 0.0) continue;
    // A point that rounding has put just outside a plane leaves through it at once.
    const double distance = std::max(0.0, (crystal.offset(face) - glm::dot(faces[face].normal, point)) / approach);
    if (!nearest || distance < nearest->distance) nearest = FaceHit{face, distance, approach, false};
  }
  return nearest;
}

}  // namespace parhelion
