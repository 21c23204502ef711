// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "math/conventions.h"

namespace parhelion {

/// The most faces a convex crystal may have: each is one bit of the intersectors' 32-bit masks.
inline constexpr int kMaxFaces = 32;

/// A planar face: of a convex crystal an outline, of any other a set of triangles. Lengths in units of the mesh,
/// normals pointing out of the crystal. A face with neither has no area: its plane lies outside the crystal, or touches
/// it.
struct Face {
  int number;                 // crystallographic (conventions.h)
  std::vector<int> vertices;  // counter-clockwise seen from outside
  Vec3 normal;                // unit
  double offset;              // normal . point, for points of the face
  double area;
  std::vector<double> fan;                         // areas of the triangles of vertices 0, i + 1, i + 2
  std::vector<std::array<int, 3>> triangles = {};  // vertices, counter-clockwise seen from outside
};

/// The edges, from vertex to vertex, that are not there in the opposite sense, too, as rings of vertices.
std::vector<std::vector<int>> openRings(const std::set<std::pair<int, int>>& edges);

/// The edges of a face that another face has, too, as rings of vertices: the face is to the left of each. Of a face
/// with holes there is more than one ring.
std::vector<std::vector<int>> outlinesOf(const Face& face);

struct FaceOutline {
  int number;
  std::vector<int> vertices;
  std::optional<Vec3> normal = std::nullopt;  // unit, where it is known better than the vertices say
  double offset = 0.0;                        // of a face without vertices, which needs a normal
};

/// A face as triangles that lie in its plane.
struct FaceTriangles {
  int number;
  Vec3 normal;    // unit
  double offset;  // normal . point, for points of the face
  std::vector<std::array<int, 3>> triangles;
};

/// A closed polyhedron in the crystal's frame.
class CrystalMesh {
 public:
  /// Throws std::invalid_argument when a face is not planar, not convex or has no area, when the surface is not closed
  /// (each edge shared by two faces that run along it in opposite directions), is turned inside out, or has too many
  /// faces.
  CrystalMesh(std::vector<Vec3> vertices, const std::vector<FaceOutline>& outlines);

  /// A crystal of any form, of faces that are sets of triangles: that they are closed and planar is known to whoever
  /// makes them. Throws std::invalid_argument when it encloses nothing.
  CrystalMesh(std::vector<Vec3> vertices, std::span<const FaceTriangles> faces);

  const std::vector<Vec3>& vertices() const { return vertices_; }
  const std::vector<Face>& faces() const { return faces_; }
  double volume() const { return volume_; }

  /// The surface in two parts: of the faces parallel to c, and of all others.
  double surfaceAlongC() const { return surfaceAlongC_; }
  double surfaceAcrossC() const { return surfaceAcrossC_; }

  /// True when faces are outlines and no vertex lies outside any face's plane.
  bool isConvex() const { return convex_; }

  /// True when every face is parallel or perpendicular to c, so that stretching the crystal along c keeps all normals.
  bool isPrismatic() const { return prismatic_; }

  /// Largest distance of a vertex from the origin.
  double radius() const { return radius_; }

 private:
  Face makeFace(const FaceOutline& outline) const;
  void checkClosed() const;
  void addUp();

  std::vector<Vec3> vertices_;
  std::vector<Face> faces_;
  double surfaceAlongC_ = 0.0, surfaceAcrossC_ = 0.0, volume_ = 0.0, radius_ = 0.0;
  bool convex_ = true, prismatic_ = true;
};

}  // namespace parhelion
