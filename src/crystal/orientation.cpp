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

/// The inverse of those that need no table.
AngleQuantile closedForm(const AngleDistribution& distribution) {
  using Kind = AngleQuantile::Kind;
  return std::visit(Overloaded{[](const FixedValue& d) {
                                 return AngleQuantile{Kind::linear, d.value, 0.0, {}};
                               },
                               [](const UniformRange& d) {
                                 return AngleQuantile{Kind::linear, d.from, d.to - d.from, {}};
                               },
                               [](const Arcsine& d) {
                                 return AngleQuantile{Kind::arcsine, d.mean, d.amplitude, {}};
                               },
                               [](const auto& d) {
                                 return AngleQuantile{Kind::linear, d.mean, 0.0, {}};
                               }},
                    distribution);
}

}  // namespace

ValueSampler::ValueSampler(const AngleDistribution& distribution, Measure measure, double lowest, double highest)
    : distribution_(distribution) {
  const auto bell = bellOf(distribution, measure);
  if (!bell) {
    quantile_ = closedForm(distribution);
    return;
  }
  const double lo = std::max(lowest, bell->mean - bell->reach), hi = std::min(highest, bell->mean + bell->reach);
  if (!(hi > lo)) throw std::invalid_argument("a distribution lies wholly outside its range");
  table_ = std::make_shared<TabulatedDensity>(bell->density, lo, hi, kCells);
  quantile_ = {AngleQuantile::Kind::table, lo, hi - lo, table_->quantile()};
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

OrientationSampler::OrientationSampler(const OrientationSettings& settings) {
  using Kind = OrientationQuantile::Kind;
  using Measure = ValueSampler::Measure;
  constexpr double kFree = std::numeric_limits<double>::infinity();
  const auto zenith = [](const AngleDistribution& d) { return ValueSampler(d, Measure::solidAngle, 0.0, kPi); };
  const auto turn = [](const AngleDistribution& d) { return ValueSampler(d, Measure::linear, -kFree, kFree); };
  const UniformRange wholeTurn{0.0, 2.0 * kPi};
  std::visit(Overloaded{[&](const RandomOrientation&) { quantile_.kind = Kind::random; },
                        [&](const AxisOrientation& s) {
                          quantile_.kind = Kind::axis;
                          angles_ = {zenith(s.zenith), turn(s.azimuth), turn(s.roll)};
                        },
                        [&](const LowitzOrientation& s) {
                          quantile_.kind = Kind::lowitz;
                          angles_ = {zenith(s.axisZenith), turn(wholeTurn), turn(s.spin)};
                        }},
             settings);
  if (angles_.empty()) return;
  quantile_.zenith = angles_[0].quantile();
  quantile_.azimuth = angles_[1].quantile();
  quantile_.roll = angles_[2].quantile();
}

}  // namespace parhelion
