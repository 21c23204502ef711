// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <variant>

#include "math/conventions.h"

namespace parhelion {

// Distributions of one angle (radians) or of the aspect ratio (no unit).

struct FixedValue {
  double value = 0.0;
};

struct UniformRange {
  double from = 0.0;
  double to = 0.0;
};

/// exp(-(x - mean)^2 / 2 sigma^2). For the zenith angle of an axis this is the density per solid angle, so that the
/// density in the angle carries a factor sin(zenith); about the zenith itself <t^2> = 2 sigma^2.
struct Normal {
  double mean = 0.0;
  double sigma = 0.0;
};

/// exp(-(x - mean)^2 / 2 sigma^2) in the angle itself, without the factor sin(zenith); <t^2> = sigma^2.
struct PolarNormal {
  double mean = 0.0;
  double sigma = 0.0;
};

/// mean + amplitude * sin(phase) with a uniform phase: a crystal that flutters. At mean 0 the folded arcsine.
struct Arcsine {
  double mean = 0.0;
  double amplitude = 0.0;
};

/// exp(-|x - mean| / scale) in the angle itself.
struct Laplace {
  double mean = 0.0;
  double scale = 0.0;
};

using AngleDistribution = std::variant<FixedValue, UniformRange, Normal, PolarNormal, Arcsine, Laplace>;
using AspectDistribution = std::variant<FixedValue, UniformRange, Normal>;

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

// Shapes.

/// Aspect ratios that are modelled; wider distributions are cut off here.
inline constexpr double kThinnestAspect = 1e-4;
inline constexpr double kLongestAspect = 1e4;

/// Hexagonal prism: a plate for aspect below 1, a column (a "pencil") above.
struct PrismSettings {
  AspectDistribution aspect = FixedValue{1.0};
};

/// Hexagonal prism with {10-11} pyramids on its ends, cut off where they are lower than a full apex.
struct PyramidSettings {
  double aspect = 1.0;           // of the prism part, L / 2a; 0: the two pyramids meet at the equator
  double upper = 0.5;            // height of the upper pyramid as a share of its full apex height, [0, 1]
  double lower = 0.5;            // the same below
  double slope = radians(28.0);  // angle between a pyramid face and the c axis
};

using ShapeSettings = std::variant<PrismSettings, PyramidSettings>;

struct PopulationSettings {
  std::string name;
  double weight = 1.0;  // share of all crystal surface in the cloud; the shares need not add up to 1
  ShapeSettings shape = PrismSettings{};
  OrientationSettings orientation = RandomOrientation{};
};

}  // namespace parhelion
