// SPDX-License-Identifier: Apache-2.0
#include "crystal/shape_spread.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

#include "crystal/orientation.h"
#include "math/overloaded.h"
#include "math/portable.h"

namespace parhelion {

namespace {

/// A distribution with a closed inverse or a table, cut off at the limits.
std::function<double(double)> quantileOf(const AngleDistribution& distribution, const LengthLimits& limits) {
  const auto sampler =
      std::make_shared<const ValueSampler>(distribution, DensityPer::unit, limits.lowest, limits.highest);
  return [sampler](double u) { return sampler->sample(u); };
}

}  // namespace

LengthLimits limitsOf(ShapeLength what) {
  using What = ShapeLength;
  switch (what) {
    case What::aspect:
      return {kThinnestAspect, kLongestAspect};
    case What::upper:
    case What::lower:
      return {0.0, 1.0};
    case What::slope:
    case What::upperSlope:
    case What::lowerSlope:
      return {radians(0.1), radians(89.9)};
    case What::sides:
      break;
  }
  return {-100.0, 100.0};
}

LengthSampler::LengthSampler(const LengthDistribution& distribution, const LengthLimits& limits) {
  const auto byLogarithm = [&](const LogNormal& d) -> std::function<double(double)> {
    const double least = std::max(limits.lowest, 1e-9);
    const auto logarithm =
        quantileOf(Normal{portable::log(d.median), d.sigma}, {portable::log(least), portable::log(limits.highest)});
    return [logarithm](double u) { return portable::exp(logarithm(u)); };
  };
  quantile_ = std::visit(Overloaded{[&](const LogNormal& d) { return byLogarithm(d); },
                                    [&](const UniformRange& d) {
                                      const double from = std::max(d.from, limits.lowest),
                                                   to = std::min(d.to, limits.highest);
                                      if (!(to >= from))
                                        throw std::invalid_argument("a distribution lies wholly outside its range");
                                      return quantileOf(UniformRange{from, to}, limits);
                                    },
                                    [&](const auto& d) { return quantileOf(d, limits); }},
                         distribution);
}

double LengthSampler::at(double u) const { return quantile_(u); }

}  // namespace parhelion
