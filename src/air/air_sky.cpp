// SPDX-License-Identifier: Apache-2.0
#include "air/air_sky.h"

#include <algorithm>
#include <cmath>

#include "math/portable.h"
#include "parallel/loops.h"

namespace parhelion {

namespace {

// Directions of the table: rows lie more densely near the horizon, by squares; columns over half a turn.
constexpr int kRowsAbove = 72, kRowsBelow = 24, kColumns = 33;
constexpr int kSteps = 48;  // of a line of sight

double angleOfSine(double sine) { return portable::atan2(sine, std::sqrt(std::max(0.0, (1.0 - sine) * (1.0 + sine)))); }

}  // namespace

/// All that lines of sight go through.
struct AirSky::Air {
  Air(const SkySettings& settings, double sunElevation, const LightBands& given)
      : air(settings),
        bands(given),
        plain(air, bands, ForwardLight::scattered),
        sentOn(air, bands, ForwardLight::goesOn),
        sun(air),
        many(air, bands, sun, sunElevation) {}

  Atmosphere air;
  const LightBands& bands;
  AirSpectrum plain, sentOn;
  SunMasses sun;
  ManyScatterings many;
};

AirSky::AirSky(const SkySettings& settings, double altitude, double sunElevation, const LightBands& bands,
               std::optional<double> cloud)
    : air_(settings),
      bands_(bands),
      plain_(air_, bands, ForwardLight::scattered),
      eye_(RayPlace::at(altitude + kEyeHeight, 0.0)),
      horizon_(angleOfSine(horizonSine(eye_.radius))),
      toSun_(portable::cos(sunElevation), 0.0, portable::sin(sunElevation)),
      cloud_(cloud) {
  const Air air(settings, sunElevation, bands);
  g_ = air.plain.g;
  restG_ = air.sentOn.g;
  fill(all_, air, false);
  if (cloud_) fill(before_, air, true);
  const auto sunAt = [&](double there) {
    Spectral share;
    for (std::size_t b = 0; b < kBands; ++b) share[b] = air_.sunTransmittance(bands.wavelength[b], there, sunElevation);
    return share;
  };
  sunlight_ = bands.colourOf(sunAt(eye_.altitude()));
  sunAtCloud_ = sunAt(cloud_.value_or(eye_.altitude()));
  atCloud_ = bands.colourOf(sunAtCloud_);
}

/// Infinite where a ray does not get there.
double AirSky::distanceToCloud(const RayPlace& from) const {
  const double altitude = *cloud_;
  if (altitude >= from.altitude()) return from.distanceToGround() < 0.0 ? from.distanceUpTo(altitude) : INFINITY;
  const bool meets = from.sine < 0.0 && from.after(from.distanceDownTo(altitude)).altitude() < altitude + 1e-6;
  return meets ? from.distanceDownTo(altitude) : INFINITY;
}

double AirSky::cloudEdge() const {
  if (!cloud_ || *cloud_ >= eye_.altitude()) return 0.0;
  const double share = (kGroundRadius + *cloud_) / eye_.radius;
  return -std::sqrt((1.0 - share) * (1.0 + share));
}

Vec3 AirSky::throughAir(double elevation) const {
  if (!cloud_) return atCloud_;
  const RayPlace from = RayPlace::at(eye_.altitude(), elevation);
  const bool isUp = *cloud_ >= eye_.altitude();
  const RayPlace there = from.after(isUp ? from.distanceUpTo(*cloud_) : from.distanceDownTo(*cloud_));
  const OfAir nearer = air_.massesToSpace(isUp ? from : there.reversed()),
              farther = air_.massesToSpace(isUp ? there : from.reversed());
  const Spectral through = plain_.transmittance({std::max(0.0, nearer.rayleigh - farther.rayleigh),
                                                 std::max(0.0, nearer.ozone - farther.ozone),
                                                 std::max(0.0, nearer.aerosol - farther.aerosol)});
  Spectral left;
  for (std::size_t b = 0; b < kBands; ++b) left[b] = sunAtCloud_[b] * through[b];
  return bands_.colourOf(left);
}

Vec3 AirSky::sunlightFrom(double elevation) const {
  const RayPlace place = RayPlace::at(eye_.altitude(), elevation);
  if (elevation < horizon_) return Vec3(0.0);
  return bands_.colourOf(plain_.transmittance(air_.massesToSpace(place)));
}

void AirSky::fill(Table& table, const Air& air, bool beforeCloud) const {
  fill(table.above, true, air, beforeCloud);
  fill(table.below, false, air, beforeCloud);
}

void AirSky::fill(std::vector<Light>& half, bool isAbove, const Air& air, bool beforeCloud) const {
  const int rows = isAbove ? kRowsAbove : kRowsBelow;
  half.resize(static_cast<std::size_t>(rows * kColumns));
  forEach(rows, [&](int row) {
    const double u = row / (rows - 1.0);
    const double elevation = horizon_ + u * u * ((isAbove ? 0.5 * kPi : -0.5 * kPi) - horizon_);
    const portable::SinCos e = portable::sincos(elevation);
    // The ray on the horizon itself belongs to both tables; rounding must not choose.
    constexpr double kBeside = 1e-7;
    const RayPlace from{eye_.radius, row > 0 ? e.sin : e.sin + (isAbove ? kBeside : -kBeside)};
    const ViewRay ray(air.air, air.plain, from, kSteps);
    const double end = beforeCloud ? distanceToCloud(from) : INFINITY;
    for (int column = 0; column < kColumns; ++column) {
      const double cosine = e.sin * toSun_.z + e.cos * toSun_.x * portable::cos(kPi * column / (kColumns - 1.0));
      half[static_cast<std::size_t>(row * kColumns + column)] = alongRay(ray, air, from.sine, cosine, end);
    }
  });
}

/// Light that aerosols have sent on nearly forwards counts as sunlight where it is scattered again, but for the bright
/// sky around the sun, which is of light scattered once. On its way to the eye it counts as scattered: near the horizon
/// the sky changes too much from one direction to the next. `sine` is that of the ray's elevation, `cosine` that of its
/// angle from the sun, `end` the distance from which on there is no light.
AirSky::Light AirSky::alongRay(const ViewRay& ray, const Air& air, double sine, double cosine, double end) const {
  const auto sunAt = [&](double altitude, double distance) {
    return SunPlace(altitude, (eye_.radius * toSun_.z + distance * cosine) / (kGroundRadius + altitude));
  };
  const double kept = keptShare(air.plain, air.sentOn);
  const double other = shareFromOtherSide(air.plain.g, sine), fromAbove = sine > 0.0 ? 1.0 - other : other;
  Spectral rayleigh{}, aerosol{}, again{}, even{};
  for (ViewRay::Step step : ray.steps()) {
    if (step.from >= end) break;
    if (step.to > end) {
      const double part = (end - step.from) / (step.to - step.from);
      for (Spectral* light : {&step.rayleigh, &step.aerosol})
        for (double& band : *light) band *= part;
    }
    const SunPlace there = sunAt(step.altitude, step.distance);
    const ScatteredLight light = air.many.at(there);
    for (std::size_t b = 0; b < kBands; ++b)
      even[b] += light.above[b] * (0.5 * step.rayleigh[b] + fromAbove * step.aerosol[b]) +
                 light.below[b] * (0.5 * step.rayleigh[b] + (1.0 - fromAbove) * step.aerosol[b]);
    if (there.share == 0.0) continue;
    const OfAir masses = air.sun.at(there);
    const Spectral through = air.plain.transmittance(masses), more = air.sentOn.transmittance(masses);
    for (std::size_t b = 0; b < kBands; ++b) {
      rayleigh[b] += there.share * more[b] * step.rayleigh[b];
      aerosol[b] += there.share * through[b] * step.aerosol[b];
      again[b] += there.share * kept * (more[b] - through[b]) * step.aerosol[b];
    }
  }
  if (ray.meetsGround() && ray.groundDistance() < end) {
    const SunPlace there = sunAt(0.0, ray.groundDistance());
    const Spectral direct = air.sentOn.transmittance(air.sun.at(there)), sky = air.many.onGround(there.sine);
    const double sun = there.share * std::max(0.0, there.sine);
    for (std::size_t b = 0; b < kBands; ++b)
      even[b] += ray.transmittance()[b] * air.air.settings().ground / kPi * (sun * direct[b] + sky[b]);
  }
  return {air.bands.colourOf(rayleigh), air.bands.colourOf(aerosol), air.bands.colourOf(again),
          air.bands.colourOf(even)};
}

AirSky::Light AirSky::mix(const Light& a, const Light& b, double t) {
  return {a.rayleigh + t * (b.rayleigh - a.rayleigh), a.aerosol + t * (b.aerosol - a.aerosol),
          a.again + t * (b.again - a.again), a.even + t * (b.even - a.even)};
}

AirSky::Light AirSky::between(const std::vector<Light>& table, int rows, double row, double azimuth) const {
  const double y = std::clamp(row, 0.0, 1.0) * (rows - 1), x = std::clamp(azimuth / kPi, 0.0, 1.0) * (kColumns - 1);
  const int j = std::min(static_cast<int>(y), rows - 2), i = std::min(static_cast<int>(x), kColumns - 2);
  const Light* low = &table[static_cast<std::size_t>(j * kColumns + i)];
  const Light* high = low + kColumns;
  return mix(mix(low[0], low[1], x - i), mix(high[0], high[1], x - i), y - j);
}

Vec3 AirSky::radiance(const Vec3& toSky) const { return radiance(all_, toSky); }

Vec3 AirSky::radianceBeforeCloud(const Vec3& toSky) const { return cloud_ ? radiance(before_, toSky) : Vec3(0.0); }

Vec3 AirSky::radiance(const Table& table, const Vec3& toSky) const {
  const double elevation = portable::atan2(toSky.z, std::sqrt(toSky.x * toSky.x + toSky.y * toSky.y));
  const double azimuth = portable::atan2(std::abs(toSky.y), toSky.x);
  const double away = elevation - horizon_;
  const Light light = away >= 0.0
                          ? between(table.above, kRowsAbove, std::sqrt(away / (0.5 * kPi - horizon_)), azimuth)
                          : between(table.below, kRowsBelow, std::sqrt(away / (-0.5 * kPi - horizon_)), azimuth);
  const double cosine = toSky.x * toSun_.x + toSky.z * toSun_.z;
  return rayleighPhase(cosine) * light.rayleigh + aerosolPhase(g_, cosine) * light.aerosol +
         aerosolPhase(restG_, cosine) * light.again + light.even;
}

}  // namespace parhelion
