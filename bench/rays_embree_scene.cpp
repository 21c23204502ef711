// SPDX-License-Identifier: Apache-2.0
#include "rays_embree_scene.h"

#include <algorithm>
#include <stdexcept>

namespace parhelion::bench {
namespace {

/// A geometry's primitives, and the face of each.
struct Fans {
  std::vector<unsigned> corners;
  std::vector<int> faceOf;

  /// A quad at the end of an odd fan has its last corner twice.
  void add(const Face& face, int index, bool triangles) {
    const auto& ring = face.vertices;
    const std::size_t last = ring.size() - 1, step = triangles ? 1 : 2;
    for (std::size_t i = 1; i < last; i += step) {
      for (const std::size_t corner : {std::size_t{0}, i, i + 1}) corners.push_back(ring[corner]);
      if (!triangles) corners.push_back(ring[std::min(i + 2, last)]);
      faceOf.push_back(index);
    }
  }
};

void rejectFaceLeft(const RTCFilterFunctionNArguments* hits) {
  const auto* faceOf = static_cast<const int*>(hits->geometryUserPtr);
  for (unsigned i = 0; i < hits->N; ++i) {
    const auto left = static_cast<int>(RTCRayN_id(hits->ray, hits->N, i));
    if (hits->valid[i] != 0 && faceOf[RTCHitN_primID(hits->hit, hits->N, i)] == left) hits->valid[i] = 0;
  }
}

}  // namespace

EmbreeScene::EmbreeScene(const CrystalMesh& mesh, const EmbreeSceneSettings& settings)
    : device_(rtcNewDevice(settings.device.c_str()), rtcReleaseDevice),
      scene_(rtcNewScene(device_.get()), rtcReleaseScene),
      together_(settings.together) {
  rtcSetSceneFlags(get(), settings.flags);
  rtcSetSceneBuildQuality(get(), settings.quality);
  const int faces = static_cast<int>(mesh.faces().size()), step = together_ ? faces : 1;
  for (int face = 0; face < faces; face += step) add(mesh, face, face + step, settings);
  rtcCommitScene(get());
  if (rtcGetDeviceError(device_.get()) != RTC_ERROR_NONE) throw std::runtime_error("Embree could not build a scene");
}

/// Adds a geometry of some faces.
void EmbreeScene::add(const CrystalMesh& mesh, int firstFace, int lastFace, const EmbreeSceneSettings& settings) {
  Fans fans;
  for (int face = firstFace; face < lastFace; ++face) fans.add(mesh.faces()[face], face, settings.triangles);
  const unsigned sides = settings.triangles ? 3 : 4;
  const std::unique_ptr<RTCGeometryTy, decltype(&rtcReleaseGeometry)> geometry(
      rtcNewGeometry(device_.get(), settings.triangles ? RTC_GEOMETRY_TYPE_TRIANGLE : RTC_GEOMETRY_TYPE_QUAD),
      rtcReleaseGeometry);
  const auto& vertices = mesh.vertices();
  auto* points = static_cast<float*>(rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0,
                                                             RTC_FORMAT_FLOAT3, 3 * sizeof(float), vertices.size()));
  auto* corners = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
      geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, settings.triangles ? RTC_FORMAT_UINT3 : RTC_FORMAT_UINT4,
      sides * sizeof(unsigned), fans.corners.size() / sides));
  if (!points || !corners) throw std::runtime_error("Embree has no memory for a crystal");
  for (const Vec3& vertex : vertices)
    for (int axis = 0; axis < 3; ++axis) *points++ = static_cast<float>(vertex[axis]);
  std::ranges::copy(fans.corners, corners);

  if (together_) faceOf_ = fans.faceOf;
  rtcSetGeometryMask(geometry.get(), together_ ? ~0u : 1u << firstFace);
  if (settings.filtered) {
    rtcSetGeometryUserData(geometry.get(), faceOf_.data());
    rtcSetGeometryIntersectFilterFunction(geometry.get(), rejectFaceLeft);
  }
  rtcCommitGeometry(geometry.get());
  rtcAttachGeometryByID(get(), geometry.get(), static_cast<unsigned>(firstFace));
}

}  // namespace parhelion::bench
