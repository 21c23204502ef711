// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <variant>

#include "crystal/distributions.h"
#include "crystal/shapes.h"
#include "math/conventions.h"

namespace parhelion {

// Orientations. Zenith angles outside [0, pi] are folded back into it.

/// Every rotation equally likely.
struct RandomOrientation {};

/// Zenith angle and azimuth of the c axis, and roll about it; see axisRotation(). Plates, columns and Parry
/// columns are such orientations: zenith about 0 or 90 degrees, azimuth free, roll free or about 0.
struct AxisOrientation {
  AngleDistribution zenith = FixedValue{};
  AngleDistribution azimuth = UniformRange{0.0, 2.0 * kPi};
  AngleDistribution roll = UniformRange{0.0, 2.0 * kPi};
};

/// The axis through two opposite prism edges (crystal +y) about horizontal, and a spin about that axis; at spin 0 the c
/// axis is at its highest. The azimuth is free.
struct LowitzOrientation {
  AngleDistribution axisZenith = FixedValue{0.5 * kPi};
  AngleDistribution spin = UniformRange{0.0, 2.0 * kPi};
};

using OrientationSettings = std::variant<RandomOrientation, AxisOrientation, LowitzOrientation>;

struct PopulationSettings {
  std::string name;
  double weight = 1.0;  // share of all crystal surface in the cloud; the shares need not add up to 1
  ShapeSettings shape = PrismSettings{};
  OrientationSettings orientation = RandomOrientation{};
};

}  // namespace parhelion
