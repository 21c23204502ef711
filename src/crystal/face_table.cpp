// SPDX-License-Identifier: Apache-2.0
#include "crystal/face_table.h"

#include <algorithm>
#include <limits>

namespace parhelion {

FaceTable::FaceTable(const CrystalMesh& mesh)
    : faces(static_cast<int>(mesh.faces().size())),
      fan(0),
      surfaceAlongC(mesh.surfaceAlongC()),
      surfaceAcrossC(mesh.surfaceAcrossC()) {
  for (const Face& face : mesh.faces()) fan = std::max(fan, static_cast<int>(face.fan.size()));
  for (const Face& face : mesh.faces()) {
    x.push_back(face.normal.x);
    y.push_back(face.normal.y);
    z.push_back(face.normal.z);
    offset.push_back(face.offset);
    area.push_back(face.area);
    areaGrows.push_back(face.normal.z == 0.0 ? 1.0 : 0.0);

    const int triangles = static_cast<int>(face.fan.size());
    const Vec3 corner = mesh.vertices()[face.vertices[0]];
    for (int j = 0; j < fan; ++j) {
      const int k = std::min(j, triangles - 1);
      const Vec3 ab = mesh.vertices()[face.vertices[k + 1]] - corner;
      const Vec3 ac = mesh.vertices()[face.vertices[k + 2]] - corner;
      triangleArea.push_back(face.fan[k]);
      triangleLimit.push_back(k + 1 < triangles ? face.fan[k] : std::numeric_limits<double>::infinity());
      cornerX.push_back(corner.x);
      cornerY.push_back(corner.y);
      cornerZ.push_back(corner.z);
      abX.push_back(ab.x);
      abY.push_back(ab.y);
      abZ.push_back(ab.z);
      acX.push_back(ac.x);
      acY.push_back(ac.y);
      acZ.push_back(ac.z);
    }
  }
}

}  // namespace parhelion
