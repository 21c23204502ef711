// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "beam/band_light.h"
#include "beam/mesh_levels.h"
#include "sky/camera.h"

namespace parhelion {

// How fine the meshes of integrateTilts() are, level by level, and what they take.

inline constexpr MeshLevels kTiltLevels{0.03, 1.8, 3};

/// What the picture and the sun blur, rad; what the sun's disc does has that radius, rad.
double blurOf(const Camera& camera, double sunRadius);

/// Size of rings and of cells along them, rad.
double cellOf(double blur, int level);

/// Of all rings and without orders, for tilts that are spread so far (rad).
BandMesh tiltMeshOf(double cell, double spread, int level);

/// Cells for 30 degrees of azimuth that light is traced at; parts of continuous light; rows of the sun's disc.
int tiltColumnsAt(int level);
int tiltLightsAt(int level);
int sunRowsOf(double radius, int cells);

/// Whether none that is worth its while is finer.
bool isFinestMesh(const Camera& camera, double sunRadius, int level);

/// What decides how long a mesh takes.
struct MeshWork {
  int bands, rings, cells;  // BandMesh: those that are made
  int columns, lights;
  int indices, prisms;  // at which light is traced
  int sunRows, pixels;
  double pixel;  // rad
};

/// More or less the seconds of one thread. The factors were measured beside those of rays (render/engine_choice.h), on
/// one machine: what matters is how they compare.
double workOf(const MeshWork& mesh);

/// How much more work a mesh and so many finer ones are than the mesh alone.
double workOfLevels(int finer);

}  // namespace parhelion
