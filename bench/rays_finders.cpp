// SPDX-License-Identifier: Apache-2.0
#include "rays_finders.h"

#include <cmath>
#include <utility>

#include "rays_queries.h"

namespace parhelion::bench {
namespace {

using Exact = long double;

Exact dot(const Vec3& a, const Vec3& b) { return Exact{a.x} * b.x + Exact{a.y} * b.y + Exact{a.z} * b.z; }

/// Along the ray to the plane of a face.
Exact distanceTo(const Crystal& crystal, int face, const Vec3& point, const Vec3& lightDir) {
  const Vec3& normal = crystal.mesh->faces()[face].normal;
  return (crystal.offset(face) - dot(normal, point)) / dot(normal, lightDir);
}

}  // namespace

FloatPlanes::FloatPlanes(const Crystal& crystal) {
  const int faces = static_cast<int>(crystal.mesh->faces().size());
  count_ = (faces + kLanes - 1) / kLanes;
  for (int i = 0; i < faces; ++i) {
    const glm::vec3 normal(crystal.mesh->faces()[i].normal);
    Four& four = faces_[i / kLanes];
    four.x[i % kLanes] = normal.x;
    four.y[i % kLanes] = normal.y;
    four.z[i % kLanes] = normal.z;
    four.offset[i % kLanes] = static_cast<float>(crystal.offset(i));
    four.index[i % kLanes] = static_cast<float>(i);
  }
}

std::span<const FinderKind> finderKinds() {
  static const std::array<FinderKind, 4> all{{
      {"embree", "Embree fast", Engine::embree},
      {"embree-robust", "Embree robust", Engine::embreeRobust},
      {"planes-float", "planes in float", {}},
      {"planes", "planes in double", Engine::planes},
  }};
  return all;
}

Finder makeFinder(const FinderKind& kind, const Cloud& cloud) {
  if (!kind.engine) return FloatPlanes(onlyCrystal(cloud));
  return std::move(makeIntersectors(cloud, *kind.engine).front());
}

int exactNextFace(const Crystal& crystal, const Vec3& point, const Vec3& lightDir, int leftFace) {
  int nearest = kNoFace;
  Exact least = std::numeric_limits<Exact>::infinity();
  const auto& faces = crystal.mesh->faces();
  for (int face = 0; face < static_cast<int>(faces.size()); ++face) {
    if (face == leftFace || !(dot(faces[face].normal, lightDir) > 0.0L)) continue;
    const Exact distance = distanceTo(crystal, face, point, lightDir);
    if (distance >= least) continue;
    least = distance;
    nearest = face;
  }
  return nearest;
}

double edgeDistance(const Crystal& crystal, const Vec3& point, const Vec3& lightDir, int exactFace, int face) {
  const Vec3& normal = crystal.mesh->faces()[face].normal;
  const Exact along = distanceTo(crystal, exactFace, point, lightDir) * dot(normal, lightDir);
  return static_cast<double>(std::abs(crystal.offset(face) - dot(normal, point) - along));
}

}  // namespace parhelion::bench
