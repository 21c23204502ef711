// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
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
    Met nearest{Lanes{} + kNoFace, Lanes{} + kNowhere, Lanes{}};
    for (int i = 0; i < count_; ++i) {
      const Met met = meet(slabs_[i], crystal.stretch, point, lightDir, leftFace);
      const Bits nearer = met.distance < nearest.distance;
      nearest.face = select(nearer, met.face, nearest.face);
      nearest.distance = select(nearer, met.distance, nearest.distance);
      nearest.cosine = select(nearer, met.cosine, nearest.cosine);
    }
    const int lane = nearest.distance[1] < nearest.distance[0];
    const int face = static_cast<int>(nearest.face[lane]);
    if (face == kNoFace) return std::nullopt;
    return FaceHit{face, std::max(0.0, nearest.distance[lane]), nearest.cosine[lane], false};
  }

 private:
  static constexpr double kNowhere = std::numeric_limits<double>::infinity();
  static constexpr int kLanes = 2;
  using Lanes = double __attribute__((vector_size(kLanes * sizeof(double))));
  using Bits = std::int64_t __attribute__((vector_size(kLanes * sizeof(double))));

  /// Slabs side by side as vectors of what registers every machine has; indices are doubles, too. A slab is two
  /// opposite faces, or one with nothing infinitely far on the other side, or has a zero normal and is never met.
  struct Slabs {
    Lanes x{}, y{}, z{};                // normal of `front`; that of `back` is its negative
    Lanes frontOffset{}, backOffset{};  // of the faces' planes at stretch 1
    Lanes fixed{}, grows{};             // 1 and 0 for offsets that do not depend on the stretch, else 0 and 1
    Lanes front{}, back{};              // faces
  };

  /// What a ray meets of some slabs.
  struct Met {
    Lanes face, distance, cosine;
  };

  static Lanes select(Bits which, Lanes a, Lanes b) {
    return reinterpret_cast<Lanes>((which & reinterpret_cast<Bits>(a)) | (~which & reinterpret_cast<Bits>(b)));
  }

  static Met meet(const Slabs& s, double stretch, const Vec3& point, const Vec3& lightDir, double leftFace) {
    const Lanes approach = s.x * lightDir.x + s.y * lightDir.y + s.z * lightDir.z;
    const Lanes height = s.x * point.x + s.y * point.y + s.z * point.z;
    const Lanes scale = s.fixed + s.grows * stretch;
    const Bits backward = approach < 0.0;
    const Lanes cosine = select(backward, -approach, approach);
    const Lanes face = select(backward, s.back, s.front);
    const Lanes gap = select(backward, s.backOffset, s.frontOffset) * scale - select(backward, -height, height);
    // 0 for the face just left. A plane that the light runs along is never met, also where rounding has put the point
    // outside it.
    const Lanes toward = select(face != leftFace, cosine, Lanes{});
    return {face, select(toward > 0.0, gap / toward, Lanes{} + kNowhere), cosine};
  }

  std::array<Slabs, kMaxFaces / kLanes> slabs_;
  int count_ = 0;  // of slabs_ in use
};

}  // namespace parhelion
