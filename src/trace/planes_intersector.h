// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "crystal/crystal.h"
#include "trace/intersector.h"

namespace parhelion {

/// A convex crystal as the half-spaces behind its faces, in double precision and no more: the nearest plane that the
/// light runs toward is the next face. Opposite faces share one set of products, as a slab of which the light can only
/// meet one side. Agrees with nextFaceByPlanes() except in ties. Immutable and safe to use from many threads.
class PlanesIntersector {
 public:
  /// Throws std::invalid_argument unless the mesh is convex.
  explicit PlanesIntersector(const CrystalMesh& mesh);

  /// The next face met from inside by the ray (`point`, `lightDir`: unit, crystal frame) in `crystal`, which is this
  /// mesh at any stretch. `leftFace`, the face the ray starts on, is left out by index. Empty only when `lightDir` is
  /// not finite.
  std::optional<FaceHit> nextFace(const Crystal& crystal, const Vec3& point, const Vec3& lightDir, int leftFace) const {
    double nearest = std::numeric_limits<double>::infinity();
    int nearestFace = kNoFace;
    for (int i = 0; i < count_; ++i) {
      const Slab& slab = slabs_[i];
      const Vec3& n = slab.normal;
      const double approach = n.x * lightDir.x + n.y * lightDir.y + n.z * lightDir.z;
      const double height = n.x * point.x + n.y * point.y + n.z * point.z;
      const int side = approach < 0.0;
      const int face = slab.face[side];
      // A plane that the light runs along is never met, also where rounding has put the point outside it.
      if (face == leftFace || !(std::abs(approach) > 0.0)) continue;
      const double offset = slab.offset[side] * (slab.stretches ? crystal.stretch : 1.0);
      const double distance = (side ? offset + height : offset - height) / std::abs(approach);
      if (distance < nearest) {
        nearest = distance;
        nearestFace = face;
      }
    }
    if (nearestFace == kNoFace) return std::nullopt;
    return FaceHit{nearestFace, std::max(0.0, nearest), false};
  }

 private:
  static constexpr double kNowhere = std::numeric_limits<double>::infinity();

  /// Two opposite faces, or one and nothing on the other side, infinitely far away.
  struct Slab {
    Vec3 normal;                   // of face[0]; that of face[1] is its negative
    std::array<double, 2> offset;  // of the faces' planes at stretch 1
    std::array<int, 2> face;
    bool stretches;  // whether the offsets grow with the crystal's stretch
  };
  std::array<Slab, kMaxFaces> slabs_;
  int count_ = 0;
};

}  // namespace parhelion
