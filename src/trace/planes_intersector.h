// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "crystal/crystal.h"
#include "trace/face_hit.h"
#include "trace/lane_steps.h"
#include "trace/slab_table.h"

namespace parhelion {

/// A convex crystal as the half-spaces behind its faces, in double precision and no more: the nearest plane that the
/// light runs toward is the next face. Agrees with nextFaceByPlanes() except in ties. Immutable and safe to use from
/// many threads.
class PlanesIntersector {
 public:
  /// Throws std::invalid_argument unless the mesh is convex.
  explicit PlanesIntersector(const CrystalMesh& mesh) : slabs_(mesh) {}

  /// The next face met from inside by the ray (`point`, `lightDir`: unit, crystal frame) in `crystal`, which is this
  /// mesh at any stretch. `leftFace`, the face the ray starts on, is left out by index. Empty only when `lightDir` is
  /// not finite.
  std::optional<FaceHit> nextFace(const Crystal& crystal, const Vec3& point, const Vec3& lightDir, int leftFace) const {
    const FaceMet<double> met = slabs_.next<double>({point.x, point.y, point.z}, {lightDir.x, lightDir.y, lightDir.z},
                                                    crystal.stretch, leftFace);
    if (met.face == kNoFace) return std::nullopt;
    return FaceHit{static_cast<int>(met.face), met.distance, met.cosine, false};
  }

  /// The same for all rays of a pool.
  int findFaces(const MeshTables&, const LaneSteps& steps, RayPool& pool) const {
    steps.findFaces(slabs_, pool);
    return 0;
  }

  /// The same for lanes; valid as long as this.
  const SlabTable& slabs() const { return slabs_; }

 private:
  SlabTable slabs_;
};

}  // namespace parhelion
