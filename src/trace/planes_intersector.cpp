// SPDX-License-Identifier: Apache-2.0
#include "trace/planes_intersector.h"

#include <stdexcept>
#include <vector>

namespace parhelion {

PlanesIntersector::PlanesIntersector(const CrystalMesh& mesh) {
  if (!mesh.isConvex()) throw std::invalid_argument("the crystal must be convex");
  const auto& faces = mesh.faces();
  std::vector<bool> taken(faces.size());
  int slabs = 0;
  for (int face = 0; face < static_cast<int>(faces.size()); ++face) {
    if (taken[face]) continue;
    const Vec3& normal = faces[face].normal;
    double backOffset = kNowhere;
    int back = kNoFace;
    for (int other = face + 1; other < static_cast<int>(faces.size()); ++other)
      if (faces[other].normal == -normal) {
        backOffset = faces[other].offset;
        back = other;
        taken[other] = true;
      }

    Slabs& s = slabs_[slabs / kLanes];
    const int k = slabs++ % kLanes;
    s.x[k] = normal.x;
    s.y[k] = normal.y;
    s.z[k] = normal.z;
    s.frontOffset[k] = faces[face].offset;
    s.backOffset[k] = backOffset;
    (normal.z == 0.0 ? s.fixed : s.grows)[k] = 1.0;
    s.front[k] = face;
    s.back[k] = back;
  }
  count_ = (slabs + kLanes - 1) / kLanes;
}

}  // namespace parhelion
