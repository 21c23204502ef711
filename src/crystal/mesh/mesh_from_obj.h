// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "crystal/crystal_mesh.h"
#include "crystal/mesh/obj_text.h"

namespace parhelion {

/// Which polygons of a mesh are one face: those in one plane that look to the same side, as far as the digits of a file
/// tell; or those of one number, which all polygons then have.
enum class OneFace { byPlane, byNumber };

/// A crystal from a closed mesh of any polygons; c is along z, and x through the middle of a prism's face 3.
///
/// By plane, a face has the number that the OBJ calls one of its polygons; the others are numbered from 1 in the order
/// of the file, past numbers that are taken. Vertices are brought into the planes of their faces. Faces that are
/// parallel but for the digits of a file are so exactly. A convex crystal of at most kMaxFaces faces is the same as one
/// by its planes; of all others faces are sets of triangles.
///
/// Throws ObjError where it is not closed, crosses or touches itself or is turned inside out, where a polygon is not
/// planar or has no area, and where one face has two numbers or one number two faces.
CrystalMesh meshFromObj(const ObjMesh& mesh, OneFace rule = OneFace::byPlane);

}  // namespace parhelion
