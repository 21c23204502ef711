// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <variant>

#include "crystal/distributions.h"
#include "crystal/shapes.h"
#include "math/conventions.h"

namespace parhelion {

// Orientations. A zenith angle is a rotation by a signed angle from the vertical: an axis that is turned beyond a pole,
// past 0 or pi, comes down on the other side. At zenith angle -t it points where it does at t and an azimuth pi
// further, and the roll is pi further, too.

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
  std::optional<LengthDistribution> size = std::nullopt;  // um, the largest distance between two corners
  double distortion = 0.0;                                // rad, spread of the tilt of a face at each encounter
  bool diffracts = false;                                 // whether faces spread the light that leaves by them
};

/// What a size may be, um; wider distributions are cut off there.
inline constexpr double kSmallestCrystal = 0.1, kLargestCrystal = 1e5;

}  // namespace parhelion
