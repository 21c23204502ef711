// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "crystal/mesh/mesh_from_obj.h"
#include "crystal/shapes/mesh.h"
#include "crystal/shapes/prism.h"

namespace parhelion {

/// The outlines of a crystal as an OBJ, moved along c, whose groups say the faces' numbers, or do not.
inline ObjMesh objOf(const CrystalMesh& mesh, double shift = 0.0, bool isNumbered = true) {
  ObjMesh obj;
  for (const Vec3& v : mesh.vertices()) obj.vertices.push_back(v + Vec3(0.0, 0.0, shift));
  int line = 1;
  for (const Face& face : mesh.faces())
    obj.polygons.push_back({face.vertices, line++, isNumbered ? std::optional(face.number) : std::nullopt});
  return obj;
}

/// Two bodies in one OBJ.
inline ObjMesh bothOf(ObjMesh one, const ObjMesh& other) {
  const int first = static_cast<int>(one.vertices.size());
  one.vertices.insert(one.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (ObjPolygon polygon : other.polygons) {
    for (int& corner : polygon.corners) corner += first;
    one.polygons.push_back(polygon);
  }
  return one;
}

/// The lower and the upper half of the regular prism of this aspect, with a gap of air between.
inline ObjMesh halvesOf(double aspect, double gap) {
  const CrystalMesh half = hexagonalPrism(0.5 * aspect);
  return bothOf(objOf(half, -0.5 * (aspect + gap)), objOf(half, 0.5 * (aspect + gap), false));
}

/// Both halves as one body: prism faces are two polygons each.
inline ObjMesh joinedHalves(double aspect) {
  ObjMesh obj;
  const CrystalMesh prism = hexagonalPrism(aspect);
  for (const double z : {-aspect, 0.0, aspect})
    for (int k = 0; k < 6; ++k) {
      const Vec3 v = prism.vertices()[static_cast<std::size_t>(k)];
      obj.vertices.emplace_back(v.x, v.y, z);
    }
  const auto number = [&](const Vec3& normal) {
    for (const Face& face : prism.faces())
      if (face.normal.x * normal.x + face.normal.y * normal.y + face.normal.z * normal.z > 0.99) return face.number;
    return 0;
  };
  for (int k = 0; k < 6; ++k) {
    const int next = (k + 1) % 6;
    const Vec3 middle = obj.vertices[static_cast<std::size_t>(k)] + obj.vertices[static_cast<std::size_t>(next)];
    const Vec3 out = Vec3(middle.x, middle.y, 0.0) / std::sqrt(middle.x * middle.x + middle.y * middle.y);
    for (const int ring : {0, 6})
      obj.polygons.push_back({{ring + k, ring + next, ring + 6 + next, ring + 6 + k}, 1, number(out)});
  }
  obj.polygons.push_back({{12, 13, 14, 15, 16, 17}, 1, 1});
  obj.polygons.push_back({{5, 4, 3, 2, 1, 0}, 1, 2});
  return obj;
}

/// A shape of that mesh.
inline MeshSettings meshed(CrystalMesh mesh) { return {"", std::make_shared<const CrystalMesh>(std::move(mesh))}; }
inline MeshSettings meshed(const ObjMesh& obj) { return meshed(meshFromObj(obj)); }

/// A convex crystal as triangles, which is followed as one that is not.
inline MeshSettings asTriangles(const CrystalMesh& mesh) {
  std::vector<FaceTriangles> faces;
  for (const Face& face : mesh.faces()) {
    faces.push_back({face.number, face.normal, face.offset, {}});
    for (std::size_t i = 1; i + 1 < face.vertices.size(); ++i)
      faces.back().triangles.push_back({face.vertices[0], face.vertices[i], face.vertices[i + 1]});
  }
  return meshed(CrystalMesh(mesh.vertices(), faces));
}

}  // namespace parhelion
