// SPDX-License-Identifier: Apache-2.0
#include "crystal/shapes/notch.h"

#include <array>
#include <cmath>

#include "crystal/mesh/mesh_from_obj.h"

namespace parhelion {

CrystalMesh notchedPrism(double aspect, const Notch& notch) {
  constexpr int kSides = 6, kCorners = 4 * kSides;
  const double apothem = 0.5 * std::sqrt(3.0);
  const std::array<double, kSides> cosine{1.0, 0.5, -0.5, -1.0, -0.5, 0.5},
      sine{0.0, apothem, apothem, 0.0, -apothem, -apothem};
  ObjMesh mesh;
  ObjPolygon bottom{{}, 0, 2}, top{{}, 0, 1};
  for (int k = 0; k < kSides; ++k) {
    // A corner of the hexagon, the mouth's beginning, the tip, the mouth's end; along the side and toward it.
    const std::array<std::array<double, 2>, 4> outline{{{-0.5, apothem},
                                                        {-0.5 * notch.width, apothem},
                                                        {0.0, apothem * (1.0 - notch.depth)},
                                                        {0.5 * notch.width, apothem}}};
    for (const auto& [along, out] : outline) {
      const double x = out * cosine[k] - along * sine[k], y = out * sine[k] + along * cosine[k];
      mesh.vertices.emplace_back(x, y, -aspect);
      mesh.vertices.emplace_back(x, y, aspect);
    }
  }
  for (int corner = 0; corner < kCorners; ++corner) {
    const int next = (corner + 1) % kCorners, side = corner / 4;
    const std::array<int, 4> number{3, 73, 83, 3};
    mesh.polygons.push_back(
        {{2 * corner, 2 * next, 2 * next + 1, 2 * corner + 1}, 0, number[static_cast<std::size_t>(corner % 4)] + side});
    top.corners.push_back(2 * corner + 1);
    bottom.corners.push_back(2 * (kCorners - 1 - corner));
  }
  mesh.polygons.push_back(top);
  mesh.polygons.push_back(bottom);
  return meshFromObj(mesh, OneFace::byNumber);
}

}  // namespace parhelion
