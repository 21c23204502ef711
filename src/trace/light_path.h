// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "trace/engine.h"
#include "trace/ray_source.h"

namespace parhelion {

/// Light that leaves a crystal.
struct Exit {
  Vec3 lightDirWorld;  // unit
  double energy;       // share of the ray's unit of intercepted light
  int order;           // 0: reflected at the outside; k: left at internal encounter k
  bool undeviated;     // goes on as if there were no crystal, through parallel faces
  int encounter = 0;   // with which it leaves: its place in LightPath::encounters, where these are recorded
};

/// One meeting of a path with a face, for replay. Directions are unit vectors in the crystal's frame.
struct Encounter {
  int faceNumber;                       // crystallographic
  Vec3 point;                           // crystal frame, crystal units
  double energyLeaving, energyStaying;  // outside and inside afterwards
  Vec3 leavingDir;                      // of the light that is outside afterwards; meaningless where there is none
  Vec3 stayingDir;                      // of the light that goes on inside; meaningless where none does
  int order;
  int before = -1;  // the encounter that the light comes from
};

/// One incident ray and all that it becomes. Reused from ray to ray so that its buffers are allocated once.
struct LightPath {
  IncidentRay incident;
  std::vector<Exit> exits;
  std::vector<Encounter> encounters;  // only where recordEncounters is set
  bool recordEncounters = false;

  double internalPath = 0.0;  // energy-weighted length inside the crystal, crystal units
  double cutOff = 0.0;        // energy still inside when the walk was given up
  double lost = 0.0;          // energy of paths that found no next face
  double absorbed = 0.0;      // energy that the crystal has taken
  int hits = 0;               // ray-face encounters, the entry included
  int rescued = 0;            // encounters the engine missed and the planes decided
};

/// Follows `path.incident` through its crystal until all its light has left, and fills in the rest of `path`; a pure
/// function of its arguments. `engine` is that of the ray's crystal. The ray's weight equals the exits' energy plus
/// cutOff plus lost plus absorbed, to rounding.
void followLight(const Intersector& engine, const TraceSettings& settings, LightPath& path);

/// Draws ray `index` and follows it: one ray of what Wave does to many, with the same bits where the engine is the
/// same.
void followRay(RaySource& source, const Intersectors& engines, const TraceSettings& settings, std::uint64_t index,
               LightPath& path);

}  // namespace parhelion
