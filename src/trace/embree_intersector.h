// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "crystal/crystal.h"
#include "trace/face_hit.h"
#include "trace/lane_steps.h"
#include "trace/ray_pool.h"

struct RTCSceneTy;

namespace parhelion {

/// An Embree device. Errors that Embree reports are recorded and thrown as std::runtime_error by the call that met
/// them.
class EmbreeDevice {
 public:
  /// `config` as rtcNewDevice takes it; `memoryLimit` in bytes, 0 for none: a build that needs more fails.
  explicit EmbreeDevice(const std::string& config = "", std::size_t memoryLimit = 0);

  struct State;
  const std::shared_ptr<State>& state() const { return state_; }

 private:
  std::shared_ptr<State> state_;
};

/// How Embree treats edges: `robust` closes the gaps between neighbouring faces at some cost in speed.
enum class EmbreeMode { fast, robust };

/// One crystal mesh in Embree, each face a geometry of its own, so that the face just left is masked out by its bit.
/// Immutable and safe to use from many threads.
class EmbreeIntersector {
 public:
  /// Throws std::runtime_error when Embree cannot build the scene. The mesh must be convex and outlive this object.
  EmbreeIntersector(const EmbreeDevice& device, const CrystalMesh& mesh, EmbreeMode mode);

  /// The next face met from inside by the ray (`point`, `lightDir`: unit, crystal frame) in `crystal`, which is this
  /// mesh at any stretch. Embree says which face; the distance comes from the face's plane in double precision. Where
  /// Embree finds none, the planes decide; empty only when they cannot either.
  std::optional<FaceHit> nextFace(const Crystal& crystal, const Vec3& point, const Vec3& lightDir, int leftFace) const;

  /// The same for all rays of a pool; returns for how many of them the planes decided.
  int findFaces(const MeshTables& tables, const LaneSteps& steps, RayPool& pool) const;

  /// What Embree alone says of all rays in a pool, into its nextFace; kNoFace where it finds none.
  void nameFaces(RayPool& pool) const;

 private:
  int faceByEmbree(double stretch, const Vec3& point, const Vec3& lightDir, int leftFace) const;

  std::shared_ptr<EmbreeDevice::State> device_;
  std::shared_ptr<RTCSceneTy> scene_;
};

}  // namespace parhelion
