// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "crystal/mesh/obj_text.h"

namespace parhelion {

/// A triangle of a polygon.
struct MeshTriangle {
  int corner[3];  // indices of vertices, counter-clockwise seen from outside
  int polygon;
};

/// Throws ObjError where an edge is not shared by exactly two polygons that run along it in opposite senses, or where
/// parts of the surface touch in a vertex alone.
void requireClosed(const ObjMesh& mesh);

/// Throws ObjError where the surface crosses or touches itself: where two triangles have more in common than the
/// vertices that they share. Exact but for parts closer than 1e-9 of the mesh's size, which touch.
void requireNoCrossing(const ObjMesh& mesh, std::span<const MeshTriangle> triangles);

/// Throws ObjError where a closed part of the surface is turned inside out, or lies inside another one. A part that is
/// turned inside out and lies in another one is the wall of a bubble of air in it, and good.
void requireOutward(const ObjMesh& mesh, std::span<const MeshTriangle> triangles);

/// Half the diagonal of the box around some vertices: what tolerances are shares of.
double sizeOf(std::span<const Vec3> vertices);

}  // namespace parhelion
