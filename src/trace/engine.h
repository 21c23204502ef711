// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <stdexcept>
#include <variant>
#include <vector>

#include "trace/cloud.h"
#include "trace/embree_intersector.h"
#include "trace/planes_intersector.h"
#include "trace/trace_settings.h"

namespace parhelion {

/// In the place of an intersector of crystals that are not convex, which a walk of their own follows
/// (trace/concave_walk.h): the faces that it meets inside.
struct ConcaveIntersector {
  const ConcaveCrystal* crystal;

  std::optional<FaceHit> nextFace(const Crystal&, const Vec3& point, const Vec3& lightDir, int leftFace) const {
    return crystal->nextFace(point, lightDir, leftFace, Side::inside);
  }
  int findFaces(const MeshTables&, const LaneSteps&, RayPool&) const {
    throw std::logic_error("crystals that are not convex are in no pool");
  }
};

/// Whatever finds the next face of one mesh. Each has the same two functions, for one ray and for all rays of a pool:
///
///   std::optional<FaceHit> nextFace(const Crystal&, const Vec3& point, const Vec3& lightDir, int leftFace) const
///   int findFaces(const MeshTables&, const LaneSteps&, RayPool&) const
///
/// The latter returns for how many rays the engine found no face and the planes decided.
using Intersector = std::variant<EmbreeIntersector, PlanesIntersector, ConcaveIntersector>;

/// One intersector a population, in the populations' order. Valid as long as the cloud.
using Intersectors = std::vector<Intersector>;

/// Whether an engine follows rays, and nothing else.
constexpr bool isTraced(Engine engine) { return engine != Engine::integral && engine != Engine::mixed; }

/// The engine asked for; where the choice is left, the planes if all crystals are convex, else Embree.
Engine engineOf(const Cloud& cloud, Engine asked);

/// What intersectors of different crystals share, made when the first of them needs it.
struct EngineDevices {
  std::optional<EmbreeDevice> embree;

  const EmbreeDevice& theEmbree() {
    if (!embree) embree.emplace();
    return *embree;
  }
};

/// The intersector of one mesh by an engine; the choice that is left falls on the planes where they can. Throws
/// std::runtime_error when Embree fails, and std::invalid_argument for the integral engine.
inline Intersector makeIntersector(Engine engine, const CrystalMesh& mesh, EngineDevices& devices) {
  switch (engine) {
    case Engine::embree:
      return EmbreeIntersector(devices.theEmbree(), mesh, EmbreeMode::fast);
    case Engine::embreeRobust:
      return EmbreeIntersector(devices.theEmbree(), mesh, EmbreeMode::robust);
    case Engine::planes:
      return PlanesIntersector(mesh);
    case Engine::integral:
    case Engine::mixed:
      throw std::invalid_argument("the integral engine follows no rays");
    case Engine::automatic:
      break;
  }
  return makeIntersector(mesh.isConvex() ? Engine::planes : Engine::embree, mesh, devices);
}

/// Crystals that are not convex have no other engine than Embree: for the planes it throws std::invalid_argument.
/// Throws std::runtime_error when Embree fails; without need of it, no Embree device is made.
Intersectors makeIntersectors(const Cloud& cloud, Engine engine);

}  // namespace parhelion
