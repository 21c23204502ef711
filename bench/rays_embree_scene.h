// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "rays_queries.h"
#include "trace/embree_api.h"
#include "trace/face_hit.h"

namespace parhelion::bench {

/// How a crystal is given to Embree; as it stands, the way of EmbreeIntersector.
struct EmbreeSceneSettings {
  bool triangles = false;  // instead of quads
  bool together = false;   // all faces in one geometry instead of each in its own
  bool filtered = false;   // a filter takes back hits of the face whose index is the ray's id
  RTCSceneFlags flags = RTC_SCENE_FLAG_NONE;
  RTCBuildQuality quality = RTC_BUILD_QUALITY_HIGH;
  std::string device = "";  // as rtcNewDevice takes it
};

/// A crystal's mesh in Embree.
class EmbreeScene {
 public:
  /// Throws std::runtime_error where Embree fails.
  EmbreeScene(const CrystalMesh& mesh, const EmbreeSceneSettings& settings);

  RTCScene get() const { return scene_.get(); }

  /// Index of the face that was hit; kNoFace for none.
  int face(unsigned geometry, unsigned primitive) const {
    if (geometry == RTC_INVALID_GEOMETRY_ID) return kNoFace;
    return together_ ? faceOf_[primitive] : static_cast<int>(geometry);
  }

 private:
  void add(const CrystalMesh& mesh, int firstFace, int lastFace, const EmbreeSceneSettings& settings);

  std::unique_ptr<RTCDeviceTy, decltype(&rtcReleaseDevice)> device_;
  std::unique_ptr<RTCSceneTy, decltype(&rtcReleaseScene)> scene_;
  bool together_;
  std::vector<int> faceOf_;  // by primitive, of the only geometry
};

/// All faces but one.
inline unsigned maskWithout(int face) { return ~(1u << face); }

/// A ray of the pool as EmbreeIntersector asks for it: taken to the mesh that is stretched to be the crystal.
inline RTCRayHit embreeQuery(const RayPool& pool, int i) {
  const double perStretch = 1.0 / pool.stretch[i];
  RTCRayHit query;
  query.ray.org_x = static_cast<float>(pool.point[0][i]);
  query.ray.org_y = static_cast<float>(pool.point[1][i]);
  query.ray.org_z = static_cast<float>(pool.point[2][i] * perStretch);
  query.ray.dir_x = static_cast<float>(pool.lightDir[0][i]);
  query.ray.dir_y = static_cast<float>(pool.lightDir[1][i]);
  query.ray.dir_z = static_cast<float>(pool.lightDir[2][i] * perStretch);
  query.ray.tnear = 0.0f;
  query.ray.tfar = std::numeric_limits<float>::infinity();
  query.ray.time = 0.0f;
  query.ray.mask = maskWithout(static_cast<int>(pool.face[i]));
  query.ray.id = static_cast<unsigned>(pool.face[i]);
  query.ray.flags = 0;
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  return query;
}

}  // namespace parhelion::bench
