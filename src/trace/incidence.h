// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "crystal/angle_quantile.h"
#include "crystal/face_table.h"
#include "optics/sun.h"

namespace parhelion {

/// What the numbers are spent on that a ray's start is drawn from. Two in a row come from one block of random bits.
enum IncidenceNumber : int {
  kZenith,
  kAzimuth,  // of the crystal
  kRoll,
  kEntryFace,
  kEntryS,
  kEntryT,  // place on the face
  kAcceptance,
  kStretch,
  kSunRadius,
  kSunAngle,  // place on the sun's disc
  kIncidenceNumbers
};

/// Numbers in (0, 1) for some bundles at a time: entry i of each array is of bundle i.
struct IncidenceNumbers {
  static constexpr int kRoom = 128;
  alignas(64) std::array<std::array<double, kRoom>, kIncidenceNumbers> row;
};

/// One population under one sun, as plain numbers that lanes can run on: what its rays are drawn from.
struct IncidenceTable {
  OrientationQuantile orientation;
  const AngleQuantile* stretch;  // null: all crystals are as the mesh is
  const FaceTable* faces;
  Triple<double> toSun;    // unit world vector toward the sun's centre
  const SunDisc* sunDisc;  // null: a point sun

  // A crystal intercepts its shadow over its surface per unit of surface. It is taken with probability interception /
  // bound, and its ray weighs 1, or the quotient where that is more. Without `rejects` every crystal is taken and the
  // ray weighs the quotient: so many rays may share the shape of their crystal, whatever light that intercepts.
  double bound;
  bool rejects;
  double lightPerRay = 1.0;  // by which all weights are multiplied, where rays are not shared out as light is

  /// No ray weighs more: the lit half of a closed surface and the dark one cast the same shadow, so that a crystal's
  /// shadow is at most half its surface.
  double highestWeight() const { return lightPerRay * std::max(1.0, 0.5 / bound); }
};

}  // namespace parhelion
