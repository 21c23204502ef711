// SPDX-License-Identifier: Apache-2.0
#include "crystal/orientation.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <stdexcept>

#include "math/overloaded.h"
#include "math/portable.h"
#include "math/rotation.h"
#include "math/turn.h"

namespace parhelion {

namespace {

// Tables reach this many standard deviations, beyond which less than 2e-15 of a normal's weight lies ...
constexpr double kNormalReach = 8.0;
// ... or this many scales of a Laplace distribution (less than 3e-16).
constexpr double kLaplaceReach = 36.0;
constexpr int kCells = 4096;

struct Bell {
  std::function<double(double)> density;
  double mean, reach;
};

/// The distributions that are tabulated; none for those inverted in closed form and for those without width.
std::optional<Bell> bellOf(const AngleDistribution& distribution, ValueSampler::Measure measure) {
  const auto gauss = [](double mean, double sigma, bool perSolidAngle) -> std::optional<Bell> {
    if (sigma == 0.0) return std::nullopt;
    const auto density = [=](double x) {
      const double t = (x - mean) / sigma;
      return portable::exp(-0.5 * t * t) * (perSolidAngle ? std::abs(portable::sin(x)) : 1.0);
    };
    return Bell{density, mean, kNormalReach * sigma};
  };
  const auto none = [](const auto&) -> std::optional<Bell> { return std::nullopt; };
  return std::visit(
      Overloaded{[&](const Normal& d) { return gauss(d.mean, d.sigma, measure == ValueSampler::Measure::solidAngle); },
                 [&](const PolarNormal& d) { return gauss(d.mean, d.sigma, false); },
                 [&](const Laplace& d) -> std::optional<Bell> {
                   if (d.scale == 0.0) return std::nullopt;
                   return Bell{[=](double x) { return portable::exp(-std::abs(x - d.mean) / d.scale); }, d.mean,
                               kLaplaceReach * d.scale};
                 },
                 none},
      distribution);
}

}  // namespace

ValueSampler::ValueSampler(const AngleDistribution& distribution, Measure measure, double lowest, double highest)
    : distribution_(distribution) {
  const auto* range = std::get_if<UniformRange>(&distribution);
  fullTurn_ = range && range->from == 0.0 && range->to == 2.0 * kPi;
  const auto bell = bellOf(distribution, measure);
  if (!bell) return;
  const double lo = std::max(lowest, bell->mean - bell->reach), hi = std::min(highest, bell->mean + bell->reach);
  if (!(hi > lo)) throw std::invalid_argument("a distribution lies wholly outside its range");
  table_ = std::make_shared<TabulatedDensity>(bell->density, lo, hi, kCells);
}

double ValueSampler::sample(double u) const {
  if (table_) return table_->sample(u);
  return std::visit(Overloaded{[](const FixedValue& d) { return d.value; },
                               [u](const UniformRange& d) { return d.from + u * (d.to - d.from); },
                               [u](const Arcsine& d) { return d.mean + d.amplitude * portable::sin(kPi * (u - 0.5)); },
                               [](const auto& d) { return d.mean; }},
                    distribution_);
}

portable::SinCos ValueSampler::sincos(double u) const {
  return fullTurn_ ? portable::sincosOfTurn(u) : portable::sincos(sample(u));
}

double ValueSampler::density(double x) const {
  if (table_) return table_->density(x);
  const auto at = [x](double value) { return x == value ? std::numeric_limits<double>::infinity() : 0.0; };
  return std::visit(Overloaded{[&](const FixedValue& d) { return at(d.value); },
                               [&](const UniformRange& d) {
                                 if (d.from == d.to) return at(d.from);
                                 return x >= d.from && x <= d.to ? 1.0 / (d.to - d.from) : 0.0;
                               },
                               [&](const Arcsine& d) {
                                 const double rest = d.amplitude * d.amplitude - (x - d.mean) * (x - d.mean);
                                 return rest > 0.0 ? 1.0 / (kPi * std::sqrt(rest)) : 0.0;
                               },
                               [&](const auto& d) { return at(d.mean); }},
                    distribution_);
}

OrientationSampler::OrientationSampler(const OrientationSettings& settings) : kind_(build(settings)) {}

OrientationSampler::Kind OrientationSampler::build(const OrientationSettings& settings) {
  using Measure = ValueSampler::Measure;
  constexpr double kFree = std::numeric_limits<double>::infinity();
  const auto zenith = [](const AngleDistribution& d) { return ValueSampler(d, Measure::solidAngle, 0.0, kPi); };
  const auto turn = [](const AngleDistribution& d) { return ValueSampler(d, Measure::linear, -kFree, kFree); };
  return std::visit(Overloaded{[](const RandomOrientation&) -> Kind { return Random{}; },
                               [&](const AxisOrientation& s) -> Kind {
                                 return Axis{zenith(s.zenith), turn(s.azimuth), turn(s.roll)};
                               },
                               [&](const LowitzOrientation& s) -> Kind {
                                 return Lowitz{zenith(s.axisZenith), turn(s.spin)};
                               }},
                    settings);
}

Mat3 OrientationSampler::sample(double u1, double u2, double u3) const {
  return std::visit(
      Overloaded{[&](const Random&) {
                   // The cosine of the zenith angle is uniform; this sine is exact near both poles.
                   const portable::SinCos zenith{2.0 * std::sqrt(u1 * (1.0 - u1)), 1.0 - 2.0 * u1};
                   return crystalOrientation(zenith, portable::sincosOfTurn(u2), portable::sincosOfTurn(u3));
                 },
                 [&](const Axis& axis) {
                   // Angles beyond the poles fold back by themselves: the rotation formula takes any
                   // angle.
                   return crystalOrientation(axis.zenith.sincos(u1), axis.azimuth.sincos(u2), axis.roll.sincos(u3));
                 },
                 [&](const Lowitz& lowitz) {
                   const double tilt = 0.5 * kPi - lowitz.axisZenith.sample(u1);
                   return rotationZ(2.0 * kPi * u2) * rotationX(tilt) * rotationY(lowitz.spin.sample(u3));
                 }},
      kind_);
}

}  // namespace parhelion
