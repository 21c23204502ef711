// SPDX-License-Identifier: Apache-2.0
#include "air/many_scatterings.h"

#include <algorithm>
#include <cmath>

#include "math/gauss_legendre.h"
#include "math/portable.h"
#include "parallel/loops.h"

namespace parhelion {

namespace {

// Along lines of sight to the air's top the sun's elevation changes by less than that.
constexpr double kReach = radians(11.0);

constexpr int kAltitudes = 14, kSuns = 33;
constexpr int kGround = 2 * kAltitudes, kRows = kGround + 1;
constexpr int kSteps = 16;  // of a ray
// Directions: above the horizontal, from there to the horizon, and below it; azimuths on one side of the sun's plane.
constexpr int kAbove = 10, kLimb = 2, kBelow = 5, kAzimuths = 4;

/// Between two neighbouring nodes of the table.
struct Between {
  std::size_t index;
  double t;
};

Between nodesAt(double x, int nodes) {
  const double inside = std::clamp(x, 0.0, nodes - 1.0);
  const int index = std::min(static_cast<int>(inside), nodes - 2);
  return {static_cast<std::size_t>(index), inside - index};
}

double cosineOf(double sine) { return std::sqrt(std::max(0.0, (1.0 - sine) * (1.0 + sine))); }

// Nodes of altitude lie more densely near the ground, by squares.
double altitudeOfNode(int node) {
  const double w = double(node) / (kAltitudes - 1);
  return kAirTop * w * w;
}

Between altitudeNodes(double altitude) {
  return nodesAt(std::sqrt(std::max(0.0, altitude) / kAirTop) * (kAltitudes - 1), kAltitudes);
}

}  // namespace

double rayleighPhase(double cosine) { return 3.0 / (16.0 * kPi) * (1.0 + cosine * cosine); }

double aerosolPhase(double g, double cosine) {
  const double x = 1.0 + g * (g - 2.0 * cosine);
  return (1.0 - g) * (1.0 + g) / (4.0 * kPi * x * std::sqrt(x));
}

double shareFromOtherSide(double g, double sine) {
  // Cones of equal shares of the light about the direction.
  constexpr int kCones = 32;
  double sum = 0.0;
  for (int i = 0; i < kCones; ++i) {
    const double u = (i + 0.5) / kCones;
    const double s = (1.0 - g) * (1.0 + g) / (1.0 - g + 2.0 * g * u);
    const double cosine = g == 0.0 ? 1.0 - 2.0 * u : std::clamp((1.0 + g * g - s * s) / (2.0 * g), -1.0, 1.0);
    // sine cosine + cos(elevation) sin(angle) cos(turn) is below 0
    const double level = std::abs(sine) * cosine, swing = cosineOf(sine) * cosineOf(cosine);
    if (swing <= std::abs(level)) {
      sum += level < 0.0 ? 1.0 : 0.0;
    } else {
      sum += portable::atan2(std::sqrt((swing - level) * (swing + level)), level) / kPi;
    }
  }
  return sum / kCones;
}

struct ManyScatterings::Direction {
  ViewRay ray;
  double sine;    // of its elevation
  double weight;  // in the sum over directions
};

ManyScatterings::ManyScatterings(const Atmosphere& air, const LightBands& bands, const SunMasses& sun,
                                 double sunElevation)
    : sun_(sun),
      plain_(air, bands, ForwardLight::scattered),
      sentOn_(air, bands, ForwardLight::goesOn),
      ground_(air.settings().ground),
      firstSine_(portable::sin(std::max(-0.5 * kPi, sunElevation - kReach))),
      lastSine_(portable::sin(std::min(0.5 * kPi, sunElevation + kReach))),
      exchange_(static_cast<std::size_t>(kRows * kRows)),
      light_(static_cast<std::size_t>(kRows * kSuns)) {
  forEach(kRows, [&](int row) {
    const bool isGround = row == kGround, looksDown = row >= kAltitudes && !isGround;
    const RayPlace place{kGroundRadius + (isGround ? 0.0 : altitudeOfNode(row % kAltitudes)), 0.0};
    const double horizon = horizonSine(place.radius);
    std::vector<Direction> directions;
    if (looksDown) {
      directions = directionsAt(air, place, -1.0, horizon, kBelow);
      for (Direction& limb : directionsAt(air, place, horizon, 0.0, kLimb)) directions.push_back(std::move(limb));
    } else {
      directions = directionsAt(air, place, 0.0, 1.0, kAbove);
    }
    if (isGround)
      for (Direction& direction : directions) direction.weight *= 2.0 * kPi * direction.sine;  // an irradiance
    addRow(directions, row);
    for (int sunNode = 0; sunNode < kSuns; ++sunNode)
      light_[static_cast<std::size_t>(row * kSuns + sunNode)] = once(directions, place, sineOfNode(sunNode));
  });
  solve();
}

double ManyScatterings::sineOfNode(int sun) const {
  return firstSine_ + (lastSine_ - firstSine_) * sun / (kSuns - 1.0);
}

/// Rays whose elevations' sines are in a range, with weights for the mean over a hemisphere.
std::vector<ManyScatterings::Direction> ManyScatterings::directionsAt(const Atmosphere& air, const RayPlace& place,
                                                                      double lo, double hi, int count) const {
  std::vector<Direction> directions;
  for (const auto& [x, weight] : gaussLegendre(count)) {
    const double sine = 0.5 * (lo + hi + (hi - lo) * x);
    directions.push_back({ViewRay(air, plain_, {place.radius, sine}, kSteps), sine, 0.5 * (hi - lo) * weight});
  }
  return directions;
}

/// The sum over directions of sunlight scattered once, or reflected by the ground.
Spectral ManyScatterings::once(const std::vector<Direction>& directions, const RayPlace& place, double sunSine) const {
  const double kept = keptShare(plain_, sentOn_);
  Spectral sum{};
  for (const Direction& direction : directions)
    for (int k = 0; k < kAzimuths; ++k) {
      const double turn = portable::cos(kPi * (k + 0.5) / kAzimuths);
      const double cosine = direction.sine * sunSine + cosineOf(direction.sine) * cosineOf(sunSine) * turn;
      const double rayleigh = rayleighPhase(cosine);
      const double aerosol = kept * aerosolPhase(sentOn_.g, cosine);
      const double weight = direction.weight / kAzimuths;
      const auto sunAt = [&](double altitude, double distance) {
        return SunPlace(altitude, (place.radius * sunSine + distance * cosine) / (kGroundRadius + altitude));
      };
      for (const ViewRay::Step& step : direction.ray.steps()) {
        const SunPlace there = sunAt(step.altitude, step.distance);
        if (there.share == 0.0) continue;
        const Spectral light = sentOn_.transmittance(sun_.at(there));
        for (std::size_t b = 0; b < kBands; ++b)
          sum[b] += weight * there.share * light[b] * (rayleigh * step.rayleigh[b] + aerosol * step.aerosol[b]);
      }
      if (!direction.ray.meetsGround()) continue;
      const SunPlace there = sunAt(0.0, direction.ray.groundDistance());
      const double reflected = weight * ground_ / kPi * there.share * std::max(0.0, there.sine);
      const Spectral light = sentOn_.transmittance(sun_.at(there));
      for (std::size_t b = 0; b < kBands; ++b) sum[b] += reflected * light[b] * direction.ray.transmittance()[b];
    }
  return sum;
}

/// What the lights of all rows bring to one along its directions.
void ManyScatterings::addRow(const std::vector<Direction>& directions, int row) {
  Spectral* exchange = &exchange_[static_cast<std::size_t>(row * kRows)];
  for (const Direction& direction : directions) {
    const double other = shareFromOtherSide(plain_.g, direction.sine);
    const double fromAbove = direction.sine > 0.0 ? 1.0 - other : other;
    for (const ViewRay::Step& step : direction.ray.steps()) {
      const Between node = altitudeNodes(step.altitude);
      const auto add = [&](std::size_t column, double weight, double aerosolShare) {
        for (std::size_t b = 0; b < kBands; ++b)
          exchange[column][b] += weight * (0.5 * step.rayleigh[b] + aerosolShare * step.aerosol[b]);
      };
      const double high = direction.weight * node.t, low = direction.weight - high;
      add(node.index, low, fromAbove);
      add(node.index + 1, high, fromAbove);
      add(kAltitudes + node.index, low, 1.0 - fromAbove);
      add(kAltitudes + node.index + 1, high, 1.0 - fromAbove);
    }
    if (!direction.ray.meetsGround()) continue;
    for (std::size_t b = 0; b < kBands; ++b)
      exchange[kGround][b] += direction.weight * ground_ / kPi * direction.ray.transmittance()[b];
  }
}

/// light = once + exchange light. No row of `exchange` sends on more than it gets, so that elimination needs no pivots.
void ManyScatterings::solve() {
  const auto rows = [](int row) { return static_cast<std::size_t>(row); };
  for (std::size_t b = 0; b < kBands; ++b) {
    std::array<std::array<double, kRows>, kRows> matrix{};
    for (int i = 0; i < kRows; ++i)
      for (int j = 0; j < kRows; ++j)
        matrix[rows(i)][rows(j)] = (i == j ? 1.0 : 0.0) - exchange_[rows(i * kRows + j)][b];
    const auto light = [&](int row, int sun) -> double& { return light_[rows(row * kSuns + sun)][b]; };
    for (int k = 0; k < kRows; ++k)
      for (int i = 0; i < kRows; ++i) {
        if (i == k) continue;
        const double factor = matrix[rows(i)][rows(k)] / matrix[rows(k)][rows(k)];
        for (int j = k; j < kRows; ++j) matrix[rows(i)][rows(j)] -= factor * matrix[rows(k)][rows(j)];
        for (int sun = 0; sun < kSuns; ++sun) light(i, sun) -= factor * light(k, sun);
      }
    for (int i = 0; i < kRows; ++i)
      for (int sun = 0; sun < kSuns; ++sun) light(i, sun) /= matrix[rows(i)][rows(i)];
  }
}

ScatteredLight ManyScatterings::at(const SunPlace& place) const {
  const Between row = altitudeNodes(place.altitude);
  const Between column = nodesAt((place.sine - firstSine_) / (lastSine_ - firstSine_) * (kSuns - 1), kSuns);
  const double t = row.t, s = column.t;
  const auto mean = [&](std::size_t first) {
    const Spectral* low = &light_[(first + row.index) * kSuns + column.index];
    const Spectral* high = low + kSuns;
    Spectral sum;
    for (std::size_t b = 0; b < kBands; ++b)
      sum[b] = (1.0 - t) * ((1.0 - s) * low[0][b] + s * low[1][b]) + t * ((1.0 - s) * high[0][b] + s * high[1][b]);
    return sum;
  };
  return {mean(0), mean(kAltitudes)};
}

Spectral ManyScatterings::onGround(double sunSine) const {
  const Between column = nodesAt((sunSine - firstSine_) / (lastSine_ - firstSine_) * (kSuns - 1), kSuns);
  const Spectral* rows = &light_[kGround * kSuns + column.index];
  Spectral irradiance;
  for (std::size_t b = 0; b < kBands; ++b) irradiance[b] = rows[0][b] + column.t * (rows[1][b] - rows[0][b]);
  return irradiance;
}

}  // namespace parhelion
