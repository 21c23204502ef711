// SPDX-License-Identifier: Apache-2.0
#include "crystal/face_table.h"

#include <algorithm>
#include <limits>

#include "crystal/span.h"

namespace parhelion {

FaceTable::FaceTable(const CrystalMesh& mesh)
    : faces(static_cast<int>(mesh.faces().size())),
      fan(0),
      surfaceAlongC(mesh.surfaceAlongC()),
      surfaceAcrossC(mesh.surfaceAcrossC()) {
  for (const Face& face : mesh.faces()) fan = std::max(fan, static_cast<int>(face.fan.size()));
  for (const Face& face : mesh.faces()) {
    for (int k = 0; k < 3; ++k) normal[k].push_back(face.normal[k]);
    offset.push_back(face.offset);
    area.push_back(face.area);
    areaGrows.push_back(face.normal.z == 0.0 ? 1.0 : 0.0);
    const FaceRectangle rectangle = rectangleOf(mesh, static_cast<int>(offset.size()) - 1);
    for (int k = 0; k < 3; ++k) {
      sideOne[k].push_back(rectangle.one[k]);
      sideOther[k].push_back(rectangle.other[k]);
    }

    const int triangles = static_cast<int>(face.fan.size());
    for (int j = 0; j < fan; ++j) {
      if (triangles == 0) {  // of a face without area, which light never enters
        triangleArea.push_back(1.0);
        triangleLimit.push_back(std::numeric_limits<double>::infinity());
        for (auto* rows : {corner, ab, ac})
          for (int k = 0; k < 3; ++k) rows[k].push_back(0.0);
        continue;
      }
      const int triangle = std::min(j, triangles - 1);
      const Vec3 a = mesh.vertices()[face.vertices[0]];
      const Vec3 b = mesh.vertices()[face.vertices[triangle + 1]], c = mesh.vertices()[face.vertices[triangle + 2]];
      triangleArea.push_back(face.fan[triangle]);
      triangleLimit.push_back(triangle + 1 < triangles ? face.fan[triangle] : std::numeric_limits<double>::infinity());
      for (int k = 0; k < 3; ++k) {
        corner[k].push_back(a[k]);
        ab[k].push_back((b - a)[k]);
        ac[k].push_back((c - a)[k]);
      }
    }
  }
}

}  // namespace parhelion
