// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "halos/closed_forms.h"
#include "halos/experiment.h"
#include "halos/position.h"

using namespace parhelion;

namespace {

Cloud columns(double sunDegrees, double aspect = 2.0) {
  return cloudUnderPointSun(radians(sunDegrees), {prisms(aspect, columnOrientation())});
}

Cloud parryColumns(double sunDegrees) {
  return cloudUnderPointSun(radians(sunDegrees), {prisms(1.0, parryOrientation())});
}

/// Elevations of all light within a fifth of a degree of the sun's vertical, whatever faces it has met: the lower
/// tangent arc of a low sun falls away steeply.
Histogram alongVertical(const Cloud& cloud, std::uint64_t rays, Histogram histogram) {
  forEachRay(cloud, rays, [&](const LightPath& path) {
    for (const Exit& exit : path.exits) {
      const SkyDegrees sky = seenAt(exit.lightDirWorld);
      if (std::abs(sky.azimuth) < 0.2) histogram.add(sky.elevation, exit.energy);
    }
  });
  return histogram;
}

/// `v` turned about the unit vector `axis`. Rodrigues' formula.
Vec3 turned(const Vec3& v, const Vec3& axis, double angle) {
  const Vec3 along = glm::dot(v, axis) * axis;
  return along + std::cos(angle) * (v - along) + std::sin(angle) * glm::cross(axis, v);
}

/// Azimuth (degrees) at which the arcs that the closed form draws for horizontal columns cross an elevation, to the
/// right of the sun.
double arcAzimuth(double sun, double elevation) {
  const Vec3 lightDir = -skyDirection(0.0, sun);
  constexpr int kSteps = 100'000;
  double below = NAN;
  SkyDegrees last{NAN, NAN};
  for (int i = 0; i < kSteps; ++i) {
    const double azimuth =
        2.0 * kPi * i / kSteps;  // of the column; the half turn more stands for the turn's other sense
    const Vec3 axis(std::cos(azimuth), std::sin(azimuth), 0.0);
    const double inclination = std::asin(glm::dot(lightDir, axis));
    const double turn = theory::leastTurn(kIndex, inclination);
    const SkyDegrees sky = std::isfinite(turn) ? seenAt(turned(lightDir, axis, turn)) : SkyDegrees{NAN, NAN};
    if (sky.azimuth > 0.0 && (sky.elevation - elevation) * (last.elevation - elevation) <= 0.0) below = sky.azimuth;
    last = sky;
  }
  return below;
}

}  // namespace

TEST_CASE("tangent arcs of columns touch the 22 degree ring above and below the sun") {
  const double ring = degrees(theory::leastDeviation(radians(60), kIndex));
  for (const double contact : {20.0 + ring, 20.0 - ring}) {
    CAPTURE(contact);
    const Histogram h = alongVertical(columns(20), 1'000'000, Histogram(contact - 3, contact + 3, 150));
    checkPosition("tangent arc" + atSun(20) + ", elevation", contact, h.peak(), 0.1);
  }
}

TEST_CASE(
    "light turned by a column's 60 degree wedges keeps its slope to the axis and turns by Bravais' angle at least") {
  double slopeError = 0.0, leastExcess = 1.0;
  forDirectLight(columns(20), 500'000, [&](const DirectLight& light) {
    if (!isWedge60(light.in, light.out)) return;
    const Vec3 axis = light.incident.crystalToWorld[2], before = light.incident.lightDirWorld;
    const double along = glm::dot(before, axis);
    slopeError = std::max(slopeError, std::abs(glm::dot(light.lightDirWorld, axis) - along));
    const double turn = angleBetween(before - along * axis, light.lightDirWorld - along * axis);
    leastExcess = std::min(leastExcess, turn - theory::leastTurn(kIndex, std::asin(along)));
  });
  CHECK(slopeError < 1e-12);
  CHECK(leastExcess > -1e-9);
  CHECK(leastExcess < radians(0.001));
}

TEST_CASE("the circumscribed halo of columns crosses the height of a sun at 45 degrees where the closed form says") {
  const double expected = arcAzimuth(radians(45), 45.0);
  for (const double side : {1.0, -1.0}) {
    Histogram h(side * expected - 4, side * expected + 4, 200);
    forEachRay(columns(45), 800'000, [&](const LightPath& path) {
      for (const Exit& exit : path.exits) {
        const SkyDegrees sky = seenAt(exit.lightDirWorld);
        if (std::abs(sky.elevation - 45.0) < 0.2) h.add(sky.azimuth, exit.energy);
      }
    });
    checkPosition("circumscribed halo" + atSun(45) + ", azimuth", side * expected, h.peak(), 0.1);
  }
}

TEST_CASE(
    "the supralateral arc of columns touches the 46 degree ring and is gone when the sun is above 32.196 degrees") {
  // Its light goes in through a side and out through an end; the infralateral arcs' the other way round, in any sun.
  struct Light {
    double supralateral = 0.0, infralateral = 0.0, closest = kPi;
  };
  const auto wedges90 = [](double sun) {
    Light sum;
    forDirectLight(columns(sun, 1.0), 300'000, [&](const DirectLight& light) {
      if (isBasal(light.in) && isPrism(light.out)) sum.infralateral += light.energy;
      if (!isPrism(light.in) || !isBasal(light.out)) return;
      sum.supralateral += light.energy;
      sum.closest = std::min(sum.closest, angleBetween(light.incident.lightDirWorld, light.lightDirWorld));
    });
    return sum;
  };
  CHECK(wedges90(20).supralateral > 0.0);
  checkPosition("supralateral arc" + atSun(20) + ", least distance from the sun",
                degrees(theory::leastDeviation(radians(90), kIndex)), degrees(wedges90(20).closest), 0.1);
  CHECK(wedges90(32.1).supralateral > 0.0);
  for (const double sun : {32.3, 40.0}) {
    CAPTURE(sun);
    CHECK(wedges90(sun).supralateral == 0.0);
    CHECK(wedges90(sun).infralateral > 0.0);
  }
}

TEST_CASE("the upper suncave Parry arc crosses the sun's vertical where Snell's law puts it") {
  // At a sun of 0 degrees the horizontal face intercepts nothing: the arc is the limit of a rising sun's.
  CHECK(std::abs(degrees(theory::suncaveParry(kIndex, 0.0)) - 43.465) < 0.001);
  CHECK(std::abs(degrees(theory::suncaveParry(kIndex, radians(20))) - 48.699) < 0.001);
  CHECK(std::abs(degrees(theory::suncaveParry(kIndex, radians(40))) - 62.499) < 0.001);
  for (const double sun : {1.0, 20.0, 40.0}) {
    CAPTURE(sun);
    const double expected = degrees(theory::suncaveParry(kIndex, radians(sun)));
    const Histogram h = alongVertical(parryColumns(sun), 1'000'000, Histogram(expected - 2, expected + 2, 100));
    checkPosition("upper suncave Parry arc" + atSun(sun) + ", elevation", expected, h.peak(), 0.1);
  }
}
