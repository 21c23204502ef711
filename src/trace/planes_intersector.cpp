// SPDX-License-Identifier: Apache-2.0
#include "trace/planes_intersector.h"

#include <stdexcept>

namespace parhelion {

PlanesIntersector::PlanesIntersector(const CrystalMesh& mesh) {
  if (!mesh.isConvex()) throw std::invalid_argument("the crystal must be convex");
  const auto& faces = mesh.faces();
  std::vector<bool> taken(faces.size());
  for (int face = 0; face < static_cast<int>(faces.size()); ++face) {
    if (taken[face]) continue;
    const Face& front = faces[face];
    Slab slab{front.normal, {front.offset, kNowhere}, {face, kNoFace}, front.normal.z != 0.0};
    for (int other = face + 1; other < static_cast<int>(faces.size()); ++other)
      if (faces[other].normal == -front.normal) {
        slab.offset[1] = faces[other].offset;
        slab.face[1] = other;
        taken[other] = true;
      }
    slabs_[count_++] = slab;
  }
}

}  // namespace parhelion
