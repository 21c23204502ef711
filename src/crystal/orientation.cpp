// SPDX-License-Identifier: Apache-2.0
#include "crystal/orientation.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <stdexcept>

#include "math/overloaded.h"

namespace parhelion {

namespace {

constexpr int kCells = 4096;

}  // namespace

ValueSampler::ValueSampler(const AngleDistribution& distribution, DensityPer per, double lowest, double highest) {
  const auto inClosedForm = [this](const ClosedForm& form) {
    quantile_ = form.inverse;
    density_ = form.density;
  };
  const auto byTable = [&](const Bell& bell) {
    const double lo = std::max(lowest, bell.mean - bell.reach), hi = std::min(highest, bell.mean + bell.reach);
    if (!(hi > lo)) throw std::invalid_argument("a distribution lies wholly outside its range");
    const auto table = std::make_shared<const TabulatedDensity>(bell.density, lo, hi, kCells);
    quantile_ = {AngleQuantile::Kind::table, lo, hi - lo, table->quantile()};
    density_ = [table](double x) { return table->density(x); };
  };
  std::visit(Overloaded{inClosedForm, byTable}, samplingOf(distribution, per));
}

OrientationSampler::OrientationSampler(const OrientationSettings& settings) {
  using Kind = OrientationQuantile::Kind;
  constexpr double kFree = std::numeric_limits<double>::infinity();
  const auto zenith = [](const AngleDistribution& d) { return ValueSampler(d, DensityPer::solidAngle, 0.0, kPi); };
  const auto turn = [](const AngleDistribution& d) { return ValueSampler(d, DensityPer::unit, -kFree, kFree); };
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
