// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "crystal/mesh/surface_checks.h"

namespace parhelion {

/// The area of a polygon times its unit normal (Newell), whatever its form.
Vec3 areaVector(const ObjMesh& mesh, const ObjPolygon& polygon);

/// All polygons as triangles: convex ones as fans, others by cutting off ears. Throws ObjError for polygons without
/// area, for those that are not planar to kFlat of the mesh's size, and for those that cross themselves.
std::vector<MeshTriangle> triangulate(const ObjMesh& mesh);

/// What digits of a file leave of planes: vertices this far off, as a share of the mesh's size, still lie in a plane.
inline constexpr double kFlat = 4e-6;

}  // namespace parhelion
