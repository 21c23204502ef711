// SPDX-License-Identifier: Apache-2.0
#include "trace/concave_crystal.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "trace/embree_api.h"
#include "trace/embree_device.h"

namespace parhelion {

namespace {

// A vertex this far beyond a face's plane, as a share of the crystal's size, still lies in it: what bringing vertices
// into their planes leaves.
constexpr double kInPlane = 1e-12;

using ConcaveGeometry = std::unique_ptr<RTCGeometryTy, decltype(&rtcReleaseGeometry)>;

/// What a ray looks for, in the one number of its own that Embree hands on to the filter: the face it starts on, and
/// the side that it is on.
unsigned queryOf(int leftFace, Side side) {
  return static_cast<unsigned>(leftFace + 1) << 1 | (side == Side::outside ? 1u : 0u);
}

/// Rejects the face that a ray starts on, and faces that it would meet from the other side. The geometry's data is the
/// face's normal.
void keepMetFaces(const RTCFilterFunctionNArguments* args) {
  const Vec3& normal = *static_cast<const Vec3*>(args->geometryUserPtr);
  for (unsigned i = 0; i < args->N; ++i) {
    if (args->valid[i] != -1) continue;
    const unsigned query = RTCRayN_id(args->ray, args->N, i);
    const double approach = normal.x * static_cast<double>(RTCRayN_dir_x(args->ray, args->N, i)) +
                            normal.y * static_cast<double>(RTCRayN_dir_y(args->ray, args->N, i)) +
                            normal.z * static_cast<double>(RTCRayN_dir_z(args->ray, args->N, i));
    const bool isOutside = (query & 1u) != 0;
    const bool isLeft = RTCHitN_geomID(args->hit, args->N, i) + 1 == query >> 1;
    if (isLeft || !(isOutside ? approach < 0.0 : approach > 0.0)) args->valid[i] = 0;
  }
}

std::vector<ConcaveCrystal::Triangle> trianglesOf(const CrystalMesh& mesh, int face) {
  std::vector<ConcaveCrystal::Triangle> triangles;
  const auto add = [&](int a, int b, int c) {
    const Vec3 corner = mesh.vertices()[a], ab = mesh.vertices()[b] - corner, ac = mesh.vertices()[c] - corner;
    triangles.push_back({corner, ab, ac, 0.5 * glm::length(glm::cross(ab, ac)), face});
  };
  const Face& own = mesh.faces()[face];
  for (std::size_t i = 1; i + 1 < own.vertices.size(); ++i) add(own.vertices[0], own.vertices[i], own.vertices[i + 1]);
  for (const auto& [a, b, c] : own.triangles) add(a, b, c);
  return triangles;
}

}  // namespace

ConcaveCrystal::ConcaveCrystal(const EmbreeDevice& device, const CrystalMesh& mesh)
    : mesh_(&mesh), device_(device.state()) {
  Vec3 lowest = mesh.vertices().front(), highest = lowest;
  for (const Vec3& v : mesh.vertices()) {
    lowest = glm::min(lowest, v);
    highest = glm::max(highest, v);
  }
  centre_ = 0.5 * (lowest + highest);
  const double size = 0.5 * glm::length(highest - lowest);
  scale_ = 1.0 / size;
  const int faces = static_cast<int>(mesh.faces().size());
  for (int face = 0; face < faces; ++face) {
    const auto own = trianglesOf(mesh, face);
    first_.push_back(static_cast<int>(triangles_.size()));
    triangles_.insert(triangles_.end(), own.begin(), own.end());
    const Face& plane = mesh.faces()[face];
    onHull_.push_back(std::ranges::all_of(
        mesh.vertices(), [&](const Vec3& v) { return glm::dot(plane.normal, v) - plane.offset <= kInPlane * size; }));
  }
  first_.push_back(static_cast<int>(triangles_.size()));
  scene_ = {rtcNewScene(device_->device), [owner = device_](RTCScene scene) { rtcReleaseScene(scene); }};
  device_->check("making a scene");
  rtcSetSceneFlags(scene_.get(), RTC_SCENE_FLAG_ROBUST);
  rtcSetSceneBuildQuality(scene_.get(), RTC_BUILD_QUALITY_HIGH);
  for (int face = 0; face < faces; ++face)
    if (!addFace(device_->device, face)) break;
  device_->check("loading a crystal");
  rtcCommitScene(scene_.get());
  device_->check("building a crystal");
}

/// Returns false when Embree has no memory for the buffers.
bool ConcaveCrystal::addFace(RTCDeviceTy* device, int face) {
  const auto begin = static_cast<std::size_t>(firstTriangle(face)),
             end = static_cast<std::size_t>(firstTriangle(face + 1));
  if (begin == end) return true;
  ConcaveGeometry geometry(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE), rtcReleaseGeometry);
  if (!geometry) return false;
  const std::size_t count = end - begin;
  auto* corners = static_cast<float*>(rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0,
                                                              RTC_FORMAT_FLOAT3, 3 * sizeof(float), 3 * count));
  auto* indices = static_cast<unsigned*>(
      rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), count));
  if (!corners || !indices) return false;
  for (std::size_t t = 0; t < count; ++t) {
    const Triangle& triangle = triangles_[begin + t];
    const Vec3 at[] = {triangle.corner, triangle.corner + triangle.ab, triangle.corner + triangle.ac};
    for (std::size_t k = 0; k < 3; ++k) {
      for (int axis = 0; axis < 3; ++axis)
        corners[9 * t + 3 * k + static_cast<std::size_t>(axis)] =
            static_cast<float>((at[k][axis] - centre_[axis]) * scale_);
      indices[3 * t + k] = static_cast<unsigned>(3 * t + k);
    }
  }
  rtcSetGeometryUserData(geometry.get(), const_cast<Vec3*>(&mesh_->faces()[face].normal));  // read alone
  rtcSetGeometryIntersectFilterFunction(geometry.get(), keepMetFaces);
  rtcCommitGeometry(geometry.get());
  rtcAttachGeometryByID(scene_.get(), geometry.get(), static_cast<unsigned>(face));
  return true;
}

int ConcaveCrystal::faceByEmbree(const Vec3& point, const Vec3& lightDir, int leftFace, Side side) const {
  const Vec3 origin = (point - centre_) * scale_;
  RTCRayHit query;
  query.ray.org_x = static_cast<float>(origin.x);
  query.ray.org_y = static_cast<float>(origin.y);
  query.ray.org_z = static_cast<float>(origin.z);
  query.ray.dir_x = static_cast<float>(lightDir.x);
  query.ray.dir_y = static_cast<float>(lightDir.y);
  query.ray.dir_z = static_cast<float>(lightDir.z);
  query.ray.tnear = 0.0f;
  query.ray.tfar = std::numeric_limits<float>::infinity();
  query.ray.time = 0.0f;
  query.ray.mask = ~0u;
  query.ray.id = queryOf(leftFace, side);
  query.ray.flags = 0;
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  intersectClosest(scene_.get(), query);
  return query.hit.geomID == RTC_INVALID_GEOMETRY_ID ? kNoFace : static_cast<int>(query.hit.geomID);
}

std::optional<FaceHit> ConcaveCrystal::nextFace(const Vec3& point, const Vec3& lightDir, int leftFace,
                                                Side side) const {
  const int face = faceByEmbree(point, lightDir, leftFace, side);
  if (face == kNoFace && side == Side::outside) return std::nullopt;
  if (face != kNoFace) {
    const Face& plane = mesh_->faces()[face];
    const double approach = glm::dot(plane.normal, lightDir);
    if (side == Side::inside ? approach > 0.0 : approach < 0.0)
      return FaceHit{face, std::max(0.0, (plane.offset - glm::dot(plane.normal, point)) / approach), std::abs(approach),
                     false};
  }
  auto hit = faceByAll(point, lightDir, leftFace, side);
  if (hit) hit->rescued = true;
  return hit;
}

std::optional<FaceHit> ConcaveCrystal::faceByAll(const Vec3& point, const Vec3& lightDir, int leftFace,
                                                 Side side) const {
  // Barycentric coordinates outside by no more than this are rounding: light that runs along an edge ends at it.
  constexpr double kEdge = 1e-9;
  std::optional<FaceHit> nearest;
  for (const Triangle& triangle : triangles_) {
    if (triangle.face == leftFace) continue;
    const double approach = glm::dot(mesh_->faces()[triangle.face].normal, lightDir);
    if (!(side == Side::inside ? approach > 0.0 : approach < 0.0)) continue;
    const Vec3 across = glm::cross(lightDir, triangle.ac), from = point - triangle.corner;
    const double volume = glm::dot(triangle.ab, across);
    const double s = glm::dot(from, across) / volume;
    const double t = glm::dot(lightDir, glm::cross(from, triangle.ab)) / volume;
    if (!(s >= -kEdge && t >= -kEdge && s + t <= 1.0 + kEdge)) continue;
    const double reach = glm::dot(triangle.ac, glm::cross(from, triangle.ab)) / volume;
    if (!(reach >= -kEdge / scale_)) continue;
    if (!nearest || reach < nearest->distance) nearest = FaceHit{triangle.face, reach, std::abs(approach), false};
  }
  if (nearest) nearest->distance = std::max(0.0, nearest->distance);
  return nearest;
}

}  // namespace parhelion
