// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string_view>
#include <variant>

#include "crystal/angle_quantile.h"

namespace parhelion {

// Distributions of one angle (radians) or of the aspect ratio (no unit). Each but the fixed value has two numbers, its
// members in the order of its words. None stops at a pole: what of a zenith angle's lies beyond stands for axes that
// come down on the other side (population_settings.h).

/// How people write a distribution: its name and what its two numbers are.
struct DistributionWords {
  std::string_view name, first, second;
  bool isRange = false;  // the numbers are its two ends; otherwise a mean and a width, with nothing spread at width 0
};

struct FixedValue {
  double value = 0.0;
};

/// exp(-(x - mean)^2 / 2 sigma^2). For the zenith angle of an axis this is the density per solid angle, so that the
/// density in the angle carries a factor |sin(zenith)|; about the zenith itself <t^2> = 2 sigma^2.
struct Normal {
  static constexpr DistributionWords kWords{"normal", "mean", "sigma"};
  double mean = 0.0;
  double sigma = 0.0;
};

struct UniformRange {
  static constexpr DistributionWords kWords{"uniform", "from", "to", true};
  double from = 0.0;
  double to = 0.0;
};

/// exp(-(x - mean)^2 / 2 sigma^2) in the angle itself, without the factor |sin(zenith)|; <t^2> = sigma^2.
struct PolarNormal {
  static constexpr DistributionWords kWords{"polar-normal", "mean", "sigma"};
  double mean = 0.0;
  double sigma = 0.0;
};

/// mean + amplitude * sin(phase) with a uniform phase: a crystal that flutters.
struct Arcsine {
  static constexpr DistributionWords kWords{"arcsine", "mean", "amplitude"};
  double mean = 0.0;
  double amplitude = 0.0;
};

/// exp(-|x - mean| / scale) in the angle itself.
struct Laplace {
  static constexpr DistributionWords kWords{"laplace", "mean", "scale"};
  double mean = 0.0;
  double scale = 0.0;
};

/// Scene files offer them in this order; a number alone where a mean is left out is the width of the first with one.
using AngleDistribution = std::variant<FixedValue, Normal, UniformRange, PolarNormal, Arcsine, Laplace>;
/// Of aspect ratios. Those that are modelled lie between the limits below; wider distributions are cut off there.
using AspectDistribution = std::variant<FixedValue, Normal, UniformRange>;

inline constexpr double kThinnestAspect = 1e-4;
inline constexpr double kLongestAspect = 1e4;

/// Degrees of a scene file become radians with a few 1e-16; an angle off by this much (rad) moves nothing that can be
/// seen.
inline constexpr double kAngleSlack = 1e-12;

/// Whether a Normal is a density per unit of the value, or per solid angle about a pole at 0 and pi.
enum class DensityPer { unit, solidAngle };

/// A density without a closed inverse: it is tabulated from mean - reach to mean + reach, beyond which there is
/// nothing.
struct Bell {
  std::function<double(double)> density;  // of any norm
  double mean, reach;
};

/// An inverse in closed form, beside its density.
struct ClosedForm {
  AngleQuantile inverse;
  std::function<double(double)> density;  // per unit of the value; infinite where a fixed value sits
};
/// How values are drawn.
using Sampling = std::variant<ClosedForm, Bell>;

Sampling samplingOf(const AngleDistribution& distribution, DensityPer per);

/// The value about which a distribution is symmetric: all of them are, about their mean.
double centreOf(const AngleDistribution& distribution);

/// Whether angles that differ by `period` are all equally likely: a uniform distribution over whole periods.
bool isFree(const AngleDistribution& distribution, double period);

/// The same distribution about `shift` more.
AngleDistribution shifted(const AngleDistribution& distribution, double shift);

/// A tilt about 0 as zenith angles of an axis that has any azimuth, so that both sides of the pole are alike: a uniform
/// one is one-sided.
AngleDistribution fromPole(const AngleDistribution& tilt);

/// What a distribution of zenith angles is as one of azimuths or rolls, which do not know solid angles.
AngleDistribution asTurn(const AngleDistribution& distribution);

}  // namespace parhelion
