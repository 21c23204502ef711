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
constexpr double kUnlimited = std::numeric_limits<double>::infinity();

ValueSampler turnSampler(const AngleDistribution& turn) { return {turn, DensityPer::unit, -kUnlimited, kUnlimited}; }

/// Zenith angles with their signs. Where all azimuths are alike so are both sides of a pole, for a crystal that the
/// half turn of roll leaves as it is, or where all rolls are alike, too: a spread about the zenith needs one side only.
ValueSampler zenithSampler(const AngleDistribution& zenith, bool sidesAlike) {
  const bool oneSide = sidesAlike && centreOf(zenith) == 0.0;
  return {zenith, DensityPer::solidAngle, oneSide ? 0.0 : -kUnlimited, kUnlimited};
}

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

OrientationSampler::OrientationSampler(const OrientationSettings& settings, bool hasHalfTurn) {
  using Kind = OrientationQuantile::Kind;
  constexpr double kTurn = 2.0 * kPi;
  std::visit(
      Overloaded{
          [&](const RandomOrientation&) { quantile_.kind = Kind::random; },
          [&](const AxisOrientation& s) {
            quantile_.kind = Kind::axis;
            angles_ = {zenithSampler(s.zenith, isFree(s.azimuth, kTurn) && (hasHalfTurn || isFree(s.roll, kTurn))),
                       turnSampler(s.azimuth), turnSampler(s.roll)};
          },
          [&](const LowitzOrientation& s) {
            quantile_.kind = Kind::lowitz;
            angles_ = {zenithSampler(s.axisZenith, false), turnSampler(UniformRange{0.0, kTurn}), turnSampler(s.spin)};
          }},
      settings);
  if (angles_.empty()) return;
  quantile_.zenith = angles_[0].quantile();
  quantile_.azimuth = angles_[1].quantile();
  quantile_.roll = angles_[2].quantile();
}

std::optional<RotationColumns<double>> standingOf(const OrientationSettings& settings) {
  if (std::holds_alternative<RandomOrientation>(settings)) return std::nullopt;
  const auto* axis = std::get_if<AxisOrientation>(&settings);
  if (axis && !isFree(axis->azimuth, 2.0 * kPi)) return std::nullopt;
  const OrientationSampler sampler(settings);
  const OrientationQuantile& one = sampler.quantile();
  const auto isFixed = [](const AngleQuantile& angle) {
    return angle.kind != AngleQuantile::Kind::table && angle.width == 0.0;
  };
  if (!isFixed(one.zenith) || !isFixed(one.roll)) return std::nullopt;
  const SineCosine<double> zenith = one.zenith.sincos(0.5), ahead{0.0, 1.0}, roll = one.roll.sincos(0.5);
  if (axis) return axisRotation(zenith, ahead, roll);
  return spinRotation(SineCosine<double>{zenith.cos, zenith.sin}, ahead, roll);
}

}  // namespace parhelion
