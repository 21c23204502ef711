// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "halos/closed_forms.h"
#include "halos/experiment.h"
#include "halos/position.h"
#include "optics/interface.h"

using namespace parhelion;

namespace {

Cloud plates(double sunDegrees, double index = kIndex, double aspect = 0.3) {
  return cloudUnderPointSun(radians(sunDegrees), {prisms(aspect, plateOrientation())}, ConstantIndex{index});
}

/// Azimuths (degrees) of all light within 0.01 degrees of an elevation, whatever faces it has met.
Histogram azimuths(const Cloud& cloud, std::uint64_t rays, double elevation, Histogram histogram) {
  forEachRay(cloud, rays, [&](const LightPath& path) {
    for (const Exit& exit : path.exits) {
      const SkyDegrees sky = seenAt(exit.lightDirWorld);
      if (std::abs(sky.elevation - elevation) < 0.01) histogram.add(sky.azimuth, exit.energy);
    }
  });
  return histogram;
}

Histogram elevations(const Cloud& cloud, std::uint64_t rays, Histogram histogram) {
  forEachRay(cloud, rays, [&](const LightPath& path) {
    for (const Exit& exit : path.exits) histogram.add(seenAt(exit.lightDirWorld).elevation, exit.energy);
  });
  return histogram;
}

double directEnergy(const Cloud& cloud, std::uint64_t rays, bool (*isWanted)(int in, int out)) {
  double sum = 0.0;
  forDirectLight(cloud, rays, [&](const DirectLight& light) { sum += isWanted(light.in, light.out) * light.energy; });
  return sum;
}

bool isTopToSide(int in, int out) { return in == 1 && isPrism(out); }
bool isSideToBottom(int in, int out) { return isPrism(in) && out == 2; }

constexpr std::uint64_t kRays = 300'000;

}  // namespace

TEST_CASE("perfect plates make parhelia at the sun's elevation, at Bravais' azimuth") {
  struct Case {
    double sun, azimuth;
  };
  for (const Case& c : {Case{0, 21.839}, Case{20, 24.576}, Case{40, 36.324}}) {
    CAPTURE(c.sun);
    const double expected = degrees(theory::leastTurn(kIndex, radians(c.sun)));
    CHECK(std::abs(expected - c.azimuth) < 0.001);
    for (const double side : {1.0, -1.0}) {
      const double middle = side * expected;
      const Histogram h = azimuths(plates(c.sun), kRays, c.sun, Histogram(middle - 5, middle + 5, 250));
      checkPosition("parhelion" + atSun(c.sun) + ", azimuth", middle, h.peak(), 0.1);
    }
  }
}

TEST_CASE("perfect plates make no parhelia when the sun is above 60.75 degrees") {
  const double last = degrees(theory::lastParhelion(kIndex));
  CHECK(std::abs(last - 60.75) < 0.005);
  // Thick plates, so that steep light crosses from side to side before it meets the lower face.
  CHECK(directEnergy(plates(last - 1.0, kIndex, 3.0), kRays, isWedge60) > 0.0);
  CHECK(directEnergy(plates(last + 0.01, kIndex, 3.0), kRays, isWedge60) == 0.0);
}

TEST_CASE("subparhelia lie below the horizon as far as the parhelia above it") {
  for (const double sun : {20.0, 40.0}) {
    CAPTURE(sun);
    const double expected = degrees(theory::leastTurn(kIndex, radians(sun)));
    for (const double side : {1.0, -1.0}) {
      const double middle = side * expected;
      const Histogram h = azimuths(plates(sun), kRays, -sun, Histogram(middle - 5, middle + 5, 250));
      checkPosition("subparhelion" + atSun(sun) + ", azimuth", middle, h.peak(), 0.1);
    }
  }
}

TEST_CASE("120 degree parhelia lie at the azimuths +-120, at the sun's elevation, whatever the index") {
  for (const double index : {1.31, 1.4}) {
    CAPTURE(index);
    for (const double middle : {120.0, -120.0}) {
      const Histogram h = azimuths(plates(20, index, 0.1), kRays, 20, Histogram(middle - 10.02, middle + 10.02, 501));
      checkPosition("120° parhelion, n = " + std::to_string(index).substr(0, 4) + ", azimuth", middle, h.peak(), 0.03);
      // All of it in one direction, far above the parhelic circle on either side.
      const double brightest = *std::max_element(h.energy.begin(), h.energy.end());
      CHECK(brightest > 20.0 * (h.total() - brightest) / 500.0);
    }
  }
}

TEST_CASE("the parhelic circle runs round the sky at the sun's elevation") {
  const Histogram circle = azimuths(plates(20), kRays, 20, Histogram(-180, 180, 36));
  CHECK(*std::min_element(circle.energy.begin(), circle.energy.end()) > 0.0);
}

TEST_CASE(
    "light of perfect plates is seen at four elevations only: the sun's, the circumzenithal arc's, their mirrors") {
  const double arc = degrees(theory::circumzenithal(kIndex, radians(20)));
  double farthest = 0.0;
  forEachRay(plates(20), kRays, [&](const LightPath& path) {
    for (const Exit& exit : path.exits) {
      const double height = std::abs(seenAt(exit.lightDirWorld).elevation);
      farthest = std::max(farthest, std::min(std::abs(height - 20.0), std::abs(height - arc)));
    }
  });
  CHECK(farthest < 1e-9);
}

TEST_CASE("the subsun lies below the sun and holds Fresnel's share of what the upper faces intercept") {
  const double aspect = 0.3, sun = radians(20);
  const double top = 1.5 * std::sqrt(3.0) * std::sin(sun), sides = 12.0 * aspect / kPi * std::cos(sun);
  const double expected = top / (top + sides) * fresnel<double>(std::sin(sun), kIndex).reflectance;
  SampleMean outside;
  double all = 0.0;
  forEachRay(plates(20, kIndex, aspect), kRays, [&](const LightPath& path) {
    double light = 0.0;
    for (const Exit& exit : path.exits) {
      const SkyDegrees sky = seenAt(exit.lightDirWorld);
      const bool isSubsun = std::abs(sky.azimuth) < 1e-6 && std::abs(sky.elevation + 20.0) < 1e-6;
      all += isSubsun * exit.energy;
      light += isSubsun && exit.order == 0 ? exit.energy : 0.0;
    }
    outside.add(light);
  });
  CHECK(outside.sigmasFrom(expected) < 4.0);
  CHECK(all / kRays > expected);  // inner reflections add to it
}

TEST_CASE("the circumzenithal arc lies at 59.753, 65.886 and 79.390 degrees for the sun at 10, 20 and 30") {
  struct Case {
    double sun, elevation;
  };
  for (const Case& c : {Case{10, 59.753}, Case{20, 65.886}, Case{30, 79.390}}) {
    CAPTURE(c.sun);
    const double expected = degrees(theory::circumzenithal(kIndex, radians(c.sun)));
    CHECK(std::abs(expected - c.elevation) < 0.001);
    const Histogram h = elevations(plates(c.sun), kRays, Histogram(50, 90, 1000));
    checkPosition("circumzenithal arc" + atSun(c.sun) + ", elevation", expected, h.peak(), 0.1);
    // It crosses the sun's vertical on the sun's side of the zenith.
    const Histogram along = azimuths(plates(c.sun), kRays, expected, Histogram(-180, 180, 36));
    CHECK(along.energy[17] + along.energy[18] > 0.0);
    CHECK(along.energy[17] + along.energy[18] > 10.0 * (along.energy[0] + along.energy[35]));
  }
}

TEST_CASE("there is no circumzenithal arc when the sun is above 32.196 degrees") {
  CHECK(directEnergy(plates(30), kRays, isTopToSide) > 0.0);
  CHECK(directEnergy(plates(35), kRays, isTopToSide) == 0.0);
  CHECK(elevations(plates(35), kRays, Histogram(50, 90.001, 1)).total() == 0.0);
}

TEST_CASE("the circumhorizontal arc lies where Snell's law says and needs the sun above 57.804 degrees") {
  for (const double sun : {60.0, 65.0, 70.0}) {
    CAPTURE(sun);
    const double expected = degrees(theory::circumhorizontal(kIndex, radians(sun)));
    const Histogram h = elevations(plates(sun), kRays, Histogram(2, 52, 1250));
    checkPosition("circumhorizontal arc" + atSun(sun) + ", elevation", expected, h.peak(), 0.1);
  }
  CHECK(directEnergy(plates(65), kRays, isSideToBottom) > 0.0);
  CHECK(directEnergy(plates(50), kRays, isSideToBottom) == 0.0);
  CHECK(elevations(plates(50), kRays, Histogram(-49, 49, 1)).total() == 0.0);
}
