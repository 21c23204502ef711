// SPDX-License-Identifier: Apache-2.0
#include "trace/slab_table.h"

#include <limits>
#include <stdexcept>
#include <vector>

#include "trace/face_hit.h"

namespace parhelion {

SlabTable::SlabTable(const CrystalMesh& mesh) {
  if (!mesh.isConvex()) throw std::invalid_argument("the crystal must be convex");
  const auto& faces = mesh.faces();
  std::vector<bool> taken(faces.size());
  for (int face = 0; face < static_cast<int>(faces.size()); ++face) {
    if (taken[face] || faces[face].area == 0.0) continue;
    const Vec3& normal = faces[face].normal;
    x[count] = normal.x;
    y[count] = normal.y;
    z[count] = normal.z;
    frontOffset[count] = faces[face].offset;
    backOffset[count] = std::numeric_limits<double>::infinity();
    front[count] = face;
    back[count] = kNoFace;
    grows[count] = normal.z != 0.0;
    for (int other = face + 1; other < static_cast<int>(faces.size()); ++other)
      if (faces[other].normal == -normal && faces[other].area > 0.0) {
        backOffset[count] = faces[other].offset;
        back[count] = other;
        taken[other] = true;
      }
    ++count;
  }
}

}  // namespace parhelion
