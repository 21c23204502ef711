// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "crystal/crystal_mesh.h"
#include "trace/embree_intersector.h"
#include "trace/face_hit.h"

struct RTCDeviceTy;

namespace parhelion {

/// Which side of a crystal's surface light is on.
enum class Side { inside, outside };

/// A crystal of any closed form, in Embree: light that has left it may meet it again. Immutable and safe to use from
/// many threads.
class ConcaveCrystal {
 public:
  /// A triangle of a face. A point of it is corner + s ab + t ac, s + t <= 1.
  struct Triangle {
    Vec3 corner, ab, ac;
    double area;
    int face;
  };

  /// Throws std::runtime_error when Embree fails. The mesh must outlive this object.
  ConcaveCrystal(const EmbreeDevice& device, const CrystalMesh& mesh);

  const CrystalMesh& mesh() const { return *mesh_; }

  /// The triangles of all faces, one face after another, and where those of a face begin.
  const std::vector<Triangle>& triangles() const { return triangles_; }
  int firstTriangle(int face) const { return first_[static_cast<std::size_t>(face)]; }

  /// Whether a face lies on the crystal's convex hull: light that leaves it to the outside meets nothing more.
  bool isOnHull(int face) const { return onHull_[static_cast<std::size_t>(face)]; }

  /// The next face met on that side by the ray (`point`, `lightDir`: unit, crystal frame). `leftFace`, the face the ray
  /// starts on, is left out by index; a face is met from one side alone, by its normal. Embree says which, in single
  /// precision; distances come from the faces' planes in double precision. Where Embree finds none inside, all
  /// triangles are tried in double precision.
  std::optional<FaceHit> nextFace(const Vec3& point, const Vec3& lightDir, int leftFace, Side side) const;

 private:
  bool addFace(RTCDeviceTy* device, int face);
  int faceByEmbree(const Vec3& point, const Vec3& lightDir, int leftFace, Side side) const;
  std::optional<FaceHit> faceByAll(const Vec3& point, const Vec3& lightDir, int leftFace, Side side) const;

  const CrystalMesh* mesh_;
  Vec3 centre_;   // of Embree's coordinates
  double scale_;  // of them
  std::vector<Triangle> triangles_;
  std::vector<int> first_;
  std::vector<char> onHull_;
  std::shared_ptr<EmbreeDevice::State> device_;
  std::shared_ptr<RTCSceneTy> scene_;
};

}  // namespace parhelion
