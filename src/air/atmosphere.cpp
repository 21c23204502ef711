// SPDX-License-Identifier: Apache-2.0
#include "air/atmosphere.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "math/conventions.h"
#include "math/gauss_legendre.h"
#include "math/portable.h"
#include "optics/tables.h"

namespace parhelion {

namespace {

constexpr double kMetresPerKilometre = 1000.0;

// The layer of ozone.
constexpr double kOzoneMiddle = 25.0, kOzoneHalfWidth = 15.0;  // km
constexpr double kOzoneBottom = kOzoneMiddle - kOzoneHalfWidth, kOzoneTop = kOzoneMiddle + kOzoneHalfWidth;

constexpr double kMoleculesPerDobson = 2.687e20;  // 1/m^2

constexpr double kSunRadius = radians(0.2665);

/// Of ozone, m^2; linear between the middles of the table's means.
double ozoneCrossSection(double wavelength) {
  const double x = (wavelength - kVisibleFirst) / kOzoneStep - 0.5;
  const int node = std::clamp(static_cast<int>(std::floor(x)), 0, kOzoneNodes - 2);
  const double t = std::clamp(x - node, 0.0, 1.0);
  const auto i = static_cast<std::size_t>(node);
  return kOzoneCrossSection[i] + t * (kOzoneCrossSection[i + 1] - kOzoneCrossSection[i]);
}

/// Nodes of an integral over [0, 1] that lie more densely at its beginning, where the air does.
const std::vector<QuadratureNode>& pathNodes() {
  static const std::vector<QuadratureNode> nodes = [] {
    constexpr int kNodes = 32;
    std::vector<QuadratureNode> dense;
    for (const auto& [x, weight] : gaussLegendre(kNodes)) {
      const double u = 0.5 * (x + 1.0);
      dense.push_back({u * u * u, 0.5 * weight * 3.0 * u * u});
    }
    return dense;
  }();
  return nodes;
}

/// Ozone on a part of a ray on which its density is linear in the altitude, between distances from the place where it
/// is nearest to the earth's centre: the integral of (r - zero) / kOzoneHalfWidth^2 ds over r = sqrt(nearest^2 + s^2).
double ozoneOf(double zero, double nearest, double from, double to) {
  const double low = std::sqrt(nearest * nearest + from * from), high = std::sqrt(nearest * nearest + to * to);
  const double bent = nearest * nearest * portable::log((to + high) / (from + low));
  return (0.5 * (to * high - from * low + bent) - zero * (to - from)) / (kOzoneHalfWidth * kOzoneHalfWidth);
}

double ozoneBetween(double nearest, double from, double to) {
  const auto at = [&](double altitude) {
    const double radius = kGroundRadius + altitude;
    return std::clamp(std::sqrt(std::max(0.0, (radius - nearest) * (radius + nearest))), from, to);
  };
  const double bottom = at(kOzoneBottom), middle = at(kOzoneMiddle), top = at(kOzoneTop);
  return ozoneOf(kGroundRadius + kOzoneBottom, nearest, bottom, middle) -
         ozoneOf(kGroundRadius + kOzoneTop, nearest, middle, top);
}

/// The amounts on a part of a ray, between distances from the place where it is nearest to the earth's centre.
OfAir massesBetween(double height, double nearest, double from, double to) {
  OfAir sum{0.0, ozoneBetween(nearest, from, to), 0.0};
  for (const auto& [x, weight] : pathNodes()) {
    const double s = from + (to - from) * x;
    const double altitude = std::max(0.0, std::sqrt(nearest * nearest + s * s) - kGroundRadius);
    const double ds = (to - from) * weight;
    sum.rayleigh += ds * portable::exp(-altitude / kRayleighHeight) / kRayleighHeight;
    sum.aerosol += ds * portable::exp(-altitude / height) / height;
  }
  return sum;
}

double opticalDepth(const OfAir& depths, const OfAir& masses) {
  return depths.rayleigh * masses.rayleigh + depths.ozone * masses.ozone + depths.aerosol * masses.aerosol;
}

}  // namespace

RayPlace RayPlace::at(double altitude, double elevation) {
  return {kGroundRadius + altitude, portable::sin(elevation)};
}

RayPlace RayPlace::after(double distance) const {
  const double along = radius * sine + distance;
  const double there = std::sqrt(radius * radius + distance * (2.0 * radius * sine + distance));
  return {there, along / there};
}

double RayPlace::distanceUpTo(double altitude) const {
  const double top = kGroundRadius + altitude, along = radius * sine;
  return std::sqrt(std::max(0.0, along * along + (top - radius) * (top + radius))) - along;
}

double RayPlace::distanceDownTo(double altitude) const {
  const double low = kGroundRadius + altitude, along = radius * sine;
  return -along - std::sqrt(std::max(0.0, along * along - (radius - low) * (radius + low)));
}

double RayPlace::distanceToGround() const {
  const double along = radius * sine;
  const double square = along * along - (radius - kGroundRadius) * (radius + kGroundRadius);
  return sine < 0.0 && square >= 0.0 ? -along - std::sqrt(square) : -1.0;
}

double horizonSine(double radius) {
  const double share = kGroundRadius / radius;
  return -std::sqrt(std::max(0.0, (1.0 - share) * (1.0 + share)));
}

double shareAboveHorizon(double above) {
  const double x = above / kSunRadius;
  if (x >= 1.0) return 1.0;
  if (x <= -1.0) return 0.0;
  const double root = std::sqrt((1.0 - x) * (1.0 + x));
  return (portable::atan2(root, -x) + x * root) / kPi;  // a circle cut by a line
}

OfAir Atmosphere::depths(double wavelength) const {
  const double micrometres = wavelength / kMetresPerKilometre;
  const double square = 1.0 / (micrometres * micrometres);
  const AerosolSettings& aerosol = settings_.aerosol;
  return {0.008569 * square * square * (1.0 + square * (0.0113 + square * 0.00013)),
          settings_.ozone * kMoleculesPerDobson * ozoneCrossSection(wavelength),
          aerosol.beta * portable::exp(-aerosol.alpha * portable::log(micrometres))};
}

OfAir Atmosphere::densities(double altitude) const {
  const double h = std::max(0.0, altitude), height = settings_.aerosol.height / kMetresPerKilometre;
  return {portable::exp(-h / kRayleighHeight) / kRayleighHeight,
          std::max(0.0, 1.0 - std::abs(h - kOzoneMiddle) / kOzoneHalfWidth) / kOzoneHalfWidth,
          portable::exp(-h / height) / height};
}

OfAir Atmosphere::massesToSpace(const RayPlace& place) const {
  const double along = place.radius * place.sine;
  const double nearest = std::sqrt(std::max(0.0, place.radius * place.radius - along * along));
  const double top = along + place.distanceUpTo(kAirTop);
  const double height = settings_.aerosol.height / kMetresPerKilometre;
  if (along >= 0.0) return massesBetween(height, nearest, along, top);
  const OfAir before = massesBetween(height, nearest, 0.0, -along), after = massesBetween(height, nearest, 0.0, top);
  return {before.rayleigh + after.rayleigh, before.ozone + after.ozone, before.aerosol + after.aerosol};
}

double Atmosphere::transmittance(double wavelength, double altitude, double elevation) const {
  const RayPlace place = RayPlace::at(altitude, elevation);
  if (place.distanceToGround() >= 0.0) return 0.0;
  return portable::exp(-opticalDepth(depths(wavelength), massesToSpace(place)));
}

double Atmosphere::sunTransmittance(double wavelength, double altitude, double elevation) const {
  const RayPlace place = RayPlace::at(altitude, elevation);
  const double horizon = horizonSine(place.radius);
  const double above = elevation - portable::atan2(horizon, std::sqrt(1.0 - horizon * horizon));
  const double share = shareAboveHorizon(above);
  if (share == 0.0) return 0.0;
  return share * portable::exp(-opticalDepth(depths(wavelength), massesToSpace(place)));
}

}  // namespace parhelion
