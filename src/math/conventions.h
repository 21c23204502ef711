// SPDX-License-Identifier: Apache-2.0
#pragma once

// The one place that says which frames, signs and units Parhelion uses.
//
// Units     Angles in radians, wavelengths in nanometres, lengths inside a crystal in units of the hexagon's side a.
//           Degrees occur only in scene files, on the command line and in output tables.
//
// World     Right-handed. +z is the zenith, +x the horizontal direction of the sun's azimuth.
//           Face the sun and stretch out your right arm: it points to sky azimuth +90 degrees, which is -y.
//           Sky azimuth is 0 at the sun and positive to the right; elevation is 0 at the horizon, positive up.
//
// Light     `lightDir` is the direction in which light travels. An observer sees that light at the point of the sky
//           toward `-lightDir`. A vector that points from the crystal or the eye to the sky has a name that begins with
//           `to`, such as `toSun`.
//
// Crystal   +z is the c axis. Faces are numbered as in halo science: 1 upper basal, 2 lower basal, 3-8 prism faces
//           counter-clockwise seen from above (from +z), 13-18 upper pyramidal, 23-28 lower pyramidal. The outward
//           normal of face 3 is the crystal's +x, so +y passes through the edge between faces 4 and 5.
//           The aspect ratio is the length along c over the distance between opposite vertices of the hexagon, L / 2a.
//
// Rotation  `crystalToWorld` takes crystal vectors to world vectors: v_world = crystalToWorld * v_crystal.
//           An orientation is the zenith angle of the c axis, its sky azimuth, and the roll about it; see rotation.h.

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace parhelion {

using Vec2 = glm::dvec2;
using Vec3 = glm::dvec3;
using Mat3 = glm::dmat3;

inline constexpr double kPi = 3.14159265358979323846;

constexpr double radians(double degrees) { return degrees * (kPi / 180.0); }
constexpr double degrees(double radians) { return radians * (180.0 / kPi); }

}  // namespace parhelion
