// SPDX-License-Identifier: Apache-2.0
#include "crystal/distributions.h"

#include <cmath>
#include <limits>

#include "math/overloaded.h"
#include "math/portable.h"

namespace parhelion {

namespace {

// Tables reach this many standard deviations, beyond which less than 2e-15 of a normal's weight lies ...
constexpr double kNormalReach = 8.0;
// ... or this many scales of a Laplace distribution (less than 3e-16).
constexpr double kLaplaceReach = 36.0;

Sampling fixedAt(double value) {
  return ClosedForm{{AngleQuantile::Kind::linear, value, 0.0, {}},
                    [=](double x) { return x == value ? std::numeric_limits<double>::infinity() : 0.0; }};
}

Sampling gauss(double mean, double sigma, bool perSolidAngle) {
  if (sigma == 0.0) return fixedAt(mean);
  const auto density = [=](double x) {
    const double t = (x - mean) / sigma;
    return portable::exp(-0.5 * t * t) * (perSolidAngle ? std::abs(portable::sin(x)) : 1.0);
  };
  return Bell{density, mean, kNormalReach * sigma};
}

Sampling sampling(const FixedValue& d, DensityPer) { return fixedAt(d.value); }
Sampling sampling(const Normal& d, DensityPer per) { return gauss(d.mean, d.sigma, per == DensityPer::solidAngle); }
Sampling sampling(const PolarNormal& d, DensityPer) { return gauss(d.mean, d.sigma, false); }

Sampling sampling(const UniformRange& d, DensityPer) {
  if (d.from == d.to) return fixedAt(d.from);
  return ClosedForm{{AngleQuantile::Kind::linear, d.from, d.to - d.from, {}},
                    [=](double x) { return x >= d.from && x <= d.to ? 1.0 / (d.to - d.from) : 0.0; }};
}

Sampling sampling(const Arcsine& d, DensityPer) {
  return ClosedForm{{AngleQuantile::Kind::arcsine, d.mean, d.amplitude, {}}, [=](double x) {
                      const double rest = d.amplitude * d.amplitude - (x - d.mean) * (x - d.mean);
                      return rest > 0.0 ? 1.0 / (kPi * std::sqrt(rest)) : 0.0;
                    }};
}

Sampling sampling(const Laplace& d, DensityPer) {
  if (d.scale == 0.0) return fixedAt(d.mean);
  return Bell{[=](double x) { return portable::exp(-std::abs(x - d.mean) / d.scale); }, d.mean,
              kLaplaceReach * d.scale};
}

double centre(const FixedValue& d) { return d.value; }

template <class D>
double centre(const D& d) {
  const auto& [first, second] = d;
  return D::kWords.isRange ? 0.5 * (first + second) : first;
}

FixedValue movedBy(double shift, const FixedValue& d) { return {d.value + shift}; }

template <class D>
D movedBy(double shift, const D& d) {
  const auto& [first, second] = d;
  return {first + shift, D::kWords.isRange ? second + shift : second};
}

FixedValue oneSided(const FixedValue& d) { return d; }

template <class D>
D oneSided(const D& d) {
  const auto& [first, second] = d;
  return {D::kWords.isRange ? 0.0 : first, second};
}

}  // namespace

Sampling samplingOf(const AngleDistribution& distribution, DensityPer per) {
  return std::visit([per](const auto& d) { return sampling(d, per); }, distribution);
}

double centreOf(const AngleDistribution& distribution) {
  return std::visit([](const auto& d) { return centre(d); }, distribution);
}

bool isFree(const AngleDistribution& distribution, double period) {
  const auto isWhole = [=](const UniformRange& d) {
    const double width = std::abs(d.to - d.from);
    return width > kAngleSlack && std::abs(std::remainder(width, period)) < kAngleSlack;
  };
  return std::visit(Overloaded{
                        [](const FixedValue&) { return false; },
                        [](const Normal&) { return false; },
                        isWhole,
                        [](const PolarNormal&) { return false; },
                        [](const Arcsine&) { return false; },
                        [](const Laplace&) { return false; },
                    },
                    distribution);
}

AngleDistribution shifted(const AngleDistribution& distribution, double shift) {
  return std::visit([shift](const auto& d) { return AngleDistribution(movedBy(shift, d)); }, distribution);
}

AngleDistribution fromPole(const AngleDistribution& tilt) {
  return std::visit([](const auto& d) { return AngleDistribution(oneSided(d)); }, tilt);
}

AngleDistribution asTurn(const AngleDistribution& distribution) {
  using Any = AngleDistribution;
  return std::visit(Overloaded{
                        [](const FixedValue& d) -> Any { return d; },
                        [](const Normal& d) -> Any { return d; },
                        [](const UniformRange& d) -> Any { return d; },
                        [](const PolarNormal& d) -> Any {
                          return Normal{d.mean, d.sigma};
                        },
                        [](const Arcsine& d) -> Any { return d; },
                        [](const Laplace& d) -> Any { return d; },
                    },
                    distribution);
}

}  // namespace parhelion
