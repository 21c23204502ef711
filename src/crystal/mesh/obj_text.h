// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "math/conventions.h"

namespace parhelion {

// Limits of what an OBJ may hold: beyond what crystals have, and so few that all of it is checked within a second.
inline constexpr int kMostObjVertices = 10'000;
inline constexpr int kMostObjPolygons = 5'000;
inline constexpr int kMostObjCorners = 256;  // of a polygon
inline constexpr int kMostObjCornersInAll = 30'000;
inline constexpr int kMostObjFaceNumber = 999;

/// What is wrong with a mesh, and where.
class ObjError : public std::invalid_argument {
 public:
  ObjError(int line, const std::string& message) : std::invalid_argument(message), line_(line) {}

  /// From 1; 0 where it is the file as a whole.
  int line() const { return line_; }

 private:
  int line_;
};

/// A polygon of an OBJ.
struct ObjPolygon {
  std::vector<int> corners;   // indices of vertices, counter-clockwise seen from outside
  int line;                   // in the file, from 1
  std::optional<int> number;  // of the face, where its group or its object is called by one
};

/// The vertices and polygons of an OBJ. Vertices at the same place are one.
struct ObjMesh {
  std::vector<Vec3> vertices;
  std::vector<ObjPolygon> polygons;
};

/// Reads the text of an OBJ (Wavefront): `v`, `f` and the names of `g` and `o` that are whole numbers. Normals,
/// textures, materials, lines and points are passed over. Throws ObjError.
ObjMesh readObj(std::string_view text);

/// An OBJ of nothing but the vertices and polygons, which reads as the same mesh, bit for bit.
std::string objText(const ObjMesh& mesh);

}  // namespace parhelion
