// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "math/rotation.h"
#include "photo/pointing.h"
#include "sky/camera.h"

namespace parhelion {
/// A projection and how far from the axis its test cameras see well.
struct LensKind {
  Projection projection;
  double reach;  // rad
  double k1;     // of radial distortion
};
inline const std::array kLenses = {
    LensKind{Projection::rectilinear, radians(55.0), 0.0},
    LensKind{Projection::rectilinear, radians(40.0), -0.08},
    LensKind{Projection::fisheyeEqualArea, radians(120.0), 0.0},
    LensKind{Projection::fisheyeEquidistant, radians(120.0), 0.0},
    LensKind{Projection::fisheyeEquidistant, radians(80.0), -0.05},
    LensKind{Projection::fisheyeStereographic, radians(120.0), 0.0},
    LensKind{Projection::fisheyeOrthographic, radians(75.0), 0.0},
    LensKind{Projection::equirectangular, radians(60.0), 0.0},
};

inline CameraSettings lensOf(const LensKind& kind) {
  CameraSettings lens;
  lens.projection = kind.projection;
  lens.fieldOfViewAxis = FieldOfViewAxis::diagonal;
  lens.fieldOfView = kind.projection == Projection::rectilinear ? radians(75.0) : 2.2 * kind.reach;
  if (kind.projection == Projection::fisheyeOrthographic) lens.fieldOfView = kPi;
  lens.width = 1500;
  lens.height = 1000;
  lens.distortion.k1 = kind.k1;
  return lens;
}

/// Random cameras and what they see.
class Draw {
 public:
  explicit Draw(unsigned seed) : random_(seed) {}

  double from(double least, double most) { return std::uniform_real_distribution(least, most)(random_); }
  double gaussian(double sigma) { return std::normal_distribution(0.0, sigma)(random_); }

  CameraSettings turned(CameraSettings lens) {
    lens.azimuth = from(-kPi, kPi);
    lens.elevation = from(-0.5 * kPi, 0.5 * kPi);
    lens.roll = from(-kPi, kPi);
    return lens;
  }

  /// Turned from the sun's azimuth, the horizon and upright by at most these angles.
  CameraSettings turned(CameraSettings lens, double azimuth, double elevation, double roll) {
    lens.azimuth = from(-azimuth, azimuth);
    lens.elevation = from(-elevation, elevation);
    lens.roll = from(-roll, roll);
    return lens;
  }

  /// A direction the lens sees, inside the frame or outside.
  Vec3 seen(const Camera& camera, double reach) {
    const CameraSettings& s = camera.settings();
    for (;;) {
      const Vec3 toSky = skyDirection(from(-kPi, kPi), std::asin(from(-1.0, 1.0)));
      if (angleBetween(toSky, skyDirection(s.azimuth, s.elevation)) < reach) return toSky;
    }
  }

 private:
  std::mt19937 random_;
};

enum class Tells { direction, azimuth, elevation };

inline PointingClue clueOf(const Camera& camera, const Vec3& toSky, Tells tells) {
  const auto place = camera.placeOf(toSky);
  REQUIRE(place.has_value());
  const SkyPoint point = skyPoint(toSky);
  PointingClue clue{*place, point.azimuth, point.elevation};
  if (tells == Tells::azimuth) clue.elevation.reset();
  if (tells == Tells::elevation) clue.azimuth.reset();
  return clue;
}

inline CameraSettings turnedAs(CameraSettings lens, const Pointing& pointing) {
  lens.azimuth = pointing.azimuth;
  lens.elevation = pointing.elevation;
  lens.roll = pointing.roll;
  return lens;
}

/// The largest angle between what two cameras show at the same places.
inline double largestDifference(const CameraSettings& a, const CameraSettings& b) {
  const Camera first(a), second(b);
  double largest = 0.0;
  for (const Vec2& place : {Vec2(750, 500), Vec2(900, 500), Vec2(750, 700), Vec2(500, 400), Vec2(700, 300)})
    largest = std::max(largest, angleBetween(first.directionAt(place).value(), second.directionAt(place).value()));
  return largest;
}

// rad. The project's aim for exact clues; rounding of places is 1e-12 of the picture and grows by tenfold or so.
inline constexpr double kExact = 1e-9;

inline CameraSettings landscape() {
  CameraSettings lens;
  lens.projection = Projection::rectilinear;
  lens.fieldOfView = radians(60.0);
  lens.width = 1500;
  lens.height = 1000;
  return lens;
}

}  // namespace parhelion
