// SPDX-License-Identifier: Apache-2.0
#include "photo/pointing_starts.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "math/portable.h"
#include "math/rotation.h"

namespace parhelion {
namespace {

// Cosines of solutions at the very border of what is possible, and elevations (rad) at the zenith: off by lost digits
// alone.
constexpr double kRounding = 1e-12;

// Squared sine between two directions below which no plane goes through them that the digits still determine.
constexpr double kLeastSquaredSine = 1e-12;

// A twelfth of a half turn: the angles on the sky change little enough from one start to the next.
constexpr int kScanSteps = 12;

double arcsine(double sine) { return portable::atan2(sine, std::sqrt(std::max(0.0, (1.0 - sine) * (1.0 + sine)))); }

/// The camera of given elevation and roll turned to where its sightings' azimuths are: by the one nearest to its
/// horizon, on which azimuths are most exact.
CameraAngles withAzimuth(std::span<const Sighting> sightings, double elevation, double roll) {
  const Mat3 tilt = cameraToWorld({0.0, elevation, roll});
  double azimuth = 0.0, farthest = -1.0;
  for (const Sighting& sighting : sightings) {
    const Vec3 toSky = tilt * sighting.inCamera;
    const double fromZenith = toSky.x * toSky.x + toSky.y * toSky.y;
    if (!sighting.azimuth || fromZenith <= farthest) continue;
    farthest = fromZenith;
    azimuth = *sighting.azimuth - skyPoint(toSky).azimuth;
  }
  return {azimuth, elevation, roll};
}

/// The two sightings whose directions are nearest to a right angle, of those that are wanted.
template <class Wanted>
std::optional<std::pair<Sighting, Sighting>> widestPair(std::span<const Sighting> sightings, const Wanted& wanted) {
  std::optional<std::pair<Sighting, Sighting>> widest;
  double most = kLeastSquaredSine;
  for (std::size_t i = 0; i < sightings.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (!wanted(sightings[i]) || !wanted(sightings[k])) continue;
      const Vec3 normal = glm::cross(sightings[k].inCamera, sightings[i].inCamera);
      if (glm::dot(normal, normal) <= most) continue;
      most = glm::dot(normal, normal);
      widest = {sightings[k], sightings[i]};
    }
  }
  return widest;
}

/// A frame of two directions that treats them alike: x between them, z across; nothing where they are too close.
std::optional<Mat3> frameOf(const Vec3& a, const Vec3& b) {
  const Vec3 across = glm::cross(a, b);
  if (glm::dot(across, across) <= kLeastSquaredSine) return std::nullopt;
  const Vec3 x = glm::normalize(a + b), z = glm::normalize(across);
  return Mat3(x, glm::cross(z, x), z);
}

/// The best rotation for two directions (Wahba's problem): their planes and bisectors are laid on each other.
std::optional<CameraAngles> fromTwoDirections(const Sighting& a, const Sighting& b) {
  const auto seen = frameOf(a.inCamera, b.inCamera);
  const auto sky = frameOf(skyDirection(*a.azimuth, *a.elevation), skyDirection(*b.azimuth, *b.elevation));
  if (!seen || !sky) return std::nullopt;
  return anglesOf(*sky * glm::transpose(*seen));
}

/// The zeniths, in the camera's frame, from which two sightings have their elevations: u = p a + q b + r a x b of unit
/// length with u a = sin h_a, u b = sin h_b. Where the two are further apart than their elevations allow, the nearest.
std::pair<Vec3, Vec3> zenithsFor(const Sighting& a, const Sighting& b) {
  const Vec3 across = glm::cross(a.inCamera, b.inCamera);
  const double cosine = glm::dot(a.inCamera, b.inCamera), squaredSine = glm::dot(across, across);
  const double sa = portable::sin(*a.elevation), sb = portable::sin(*b.elevation);
  const double p = (sa - cosine * sb) / squaredSine, q = (sb - cosine * sa) / squaredSine;
  const double left = 1.0 - (p * p + q * q + 2.0 * p * q * cosine);
  const double r = std::sqrt(std::max(0.0, left) / squaredSine);
  const Vec3 plane = p * a.inCamera + q * b.inCamera;
  return {glm::normalize(plane + r * across), glm::normalize(plane - r * across)};
}

void scan(std::span<const Sighting> sightings, std::optional<double> roll, std::vector<CameraAngles>& starts) {
  const double step = kPi / kScanSteps;
  for (int i = 0; i <= kScanSteps; ++i) {
    const double elevation = std::min(i * step, kPi) - 0.5 * kPi;
    if (roll) starts.push_back(withAzimuth(sightings, elevation, *roll));
    for (int k = 0; k < 2 * kScanSteps && !roll; ++k) starts.push_back(withAzimuth(sightings, elevation, k * step));
  }
}

}  // namespace

std::vector<double> elevationsFor(const Sighting& sighting, double roll) {
  // Turned up by e, the rolled direction (x, y, z) has the height x sin e + z cos e = reach cos(e - highest).
  const Vec3 rolled = rotationX(roll) * sighting.inCamera;
  const double reach = std::sqrt(rolled.x * rolled.x + rolled.z * rolled.z);
  const double cosine = portable::sin(*sighting.elevation) / reach;
  if (!(std::abs(cosine) <= 1.0 + kRounding)) return {};
  const double highest = portable::atan2(rolled.x, rolled.z);
  const double apart = 0.5 * kPi - arcsine(std::clamp(cosine, -1.0, 1.0));
  std::vector<double> elevations;
  for (double elevation : {highest - apart, highest + apart}) {
    if (elevation > kPi) elevation -= 2.0 * kPi;
    if (elevation < -kPi) elevation += 2.0 * kPi;
    if (std::abs(elevation) <= 0.5 * kPi + kRounding)
      elevations.push_back(std::clamp(elevation, -0.5 * kPi, 0.5 * kPi));
  }
  return elevations;
}

ElevationRange elevationsSeen(const Vec3& inCamera, double roll) {
  const Vec3 rolled = rotationX(roll) * inCamera;
  const double farthest = arcsine(std::min(1.0, std::sqrt(rolled.x * rolled.x + rolled.z * rolled.z)));
  // At the camera's elevations of +-90 degrees the height is +-x.
  const double border = arcsine(std::min(1.0, std::abs(rolled.x)));
  return rolled.z >= 0.0 ? ElevationRange{-border, farthest} : ElevationRange{-farthest, border};
}

std::vector<CameraAngles> pointingStarts(std::span<const Sighting> sightings, std::optional<double> roll) {
  std::vector<CameraAngles> starts;
  if (roll) {
    for (const Sighting& sighting : sightings) {
      if (!sighting.elevation) continue;
      for (const double elevation : elevationsFor(sighting, *roll))
        starts.push_back(withAzimuth(sightings, elevation, *roll));
    }
  } else {
    if (const auto pair = widestPair(sightings, [](const Sighting& s) { return s.isDirection(); })) {
      if (const auto angles = fromTwoDirections(pair->first, pair->second)) starts.push_back(*angles);
    }
    if (const auto pair = widestPair(sightings, [](const Sighting& s) { return s.elevation.has_value(); })) {
      const auto [first, second] = zenithsFor(pair->first, pair->second);
      for (const Vec3& zenith : {first, second}) {
        const double elevation = portable::atan2(zenith.x, std::sqrt(zenith.y * zenith.y + zenith.z * zenith.z));
        starts.push_back(withAzimuth(sightings, elevation, portable::atan2(zenith.y, zenith.z)));
      }
    }
  }
  if (starts.empty()) scan(sightings, roll, starts);
  return starts;
}

}  // namespace parhelion
