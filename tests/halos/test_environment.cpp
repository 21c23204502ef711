// SPDX-License-Identifier: Apache-2.0
// Environment light: a known arc at the pixel where other programs look for its direction.
#include <doctest/doctest.h>

#include <ImfEnvmap.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "halos/closed_forms.h"
#include "halos/experiment.h"
#include "math/rotation.h"
#include "sky/camera.h"
#include "sky/radiance.h"
#include "trace/expose.h"

using namespace parhelion;

namespace {

constexpr int kWidth = 1024, kHeight = 512;
constexpr double kSun = radians(20);

/// A whole sphere with the sun's azimuth in the centre column.
TallyInfo wholeSphere() {
  TallyInfo info;
  info.seed = 5;
  info.white = {1.0, 1.0, 1.0};
  info.sunElevation = kSun;
  info.camera.projection = Projection::equirectangular;
  info.camera.elevation = 0.0;
  info.camera.fieldOfView = 2.0 * kPi;
  info.camera.width = kWidth;
  info.camera.height = kHeight;
  return info;
}

/// Level plates turned counter-clockwise by about 19 degrees: the sun strikes a face at the right at the incidence of
/// least deviation, and none at the left. A sky of one parhelion cannot be taken for its mirror image.
Cloud oneSidedPlates() {
  const AxisOrientation turned{FixedValue{}, FixedValue{}, UniformRange{radians(14), radians(24)}};
  return cloudUnderPointSun(kSun, {prisms(0.3, turned)});
}

/// Their sky in light of one wavelength, unfiltered.
Image platesSky() {
  const Cloud cloud = oneSidedPlates();
  SkyTally tally(Tally(wholeSphere(), 1));
  traceTally(tally, cloud, {.rays = 1'000'000, .seed = 5, .symmetry = Symmetry::none});
  return plainRadiance(tally.parts().front().tally);
}

/// Unit world vector toward a point of the sky.
Vec3 toSky(const SkyPoint& sky) {
  return {std::cos(sky.elevation) * std::cos(sky.azimuth), -std::cos(sky.elevation) * std::sin(sky.azimuth),
          std::sin(sky.elevation)};
}

struct Pixel {
  int x, y;
};

float at(const Image& sky, Pixel p) { return (*sky.find("G"))[static_cast<std::size_t>(p.y * kWidth + p.x)]; }

/// The brightest pixel of a window.
Pixel brightest(const Image& sky, Pixel from, Pixel to) {
  Pixel best = from;
  for (int y = from.y; y < to.y; ++y)
    for (int x = from.x; x < to.x; ++x)
      if (at(sky, {x, y}) > at(sky, best)) best = {x, y};
  return best;
}

/// Where a program looks up a direction of our world (sun toward +x, zenith +z, observer's right toward -y).
struct Program {
  const char* name;
  std::function<Vec2(const Vec3&)> pixelOf;  // pixel coordinates, from the borders
};

Vec2 ofShares(double u, double v) { return {u * kWidth, (1.0 - v) * kHeight}; }

/// Cycles, intern/cycles/kernel/camera/projection.h, direction_to_equirectangular. +Z is up, and its world is ours.
Vec2 blender(const Vec3& d) {
  const double u = (std::atan2(d.y, d.x) - kPi) / (-2.0 * kPi), v = (std::acos(d.z) - kPi) / -kPi;
  return ofShares(u, v);
}

/// Our direction in a world whose +y is up, with the sun's azimuth toward +z.
Vec3 yUp(const Vec3& d) { return {d.y, d.z, d.x}; }

/// UsdLuxDomeLight as its schema words it: latitudes -pi/2 and pi/2 toward -y and +y, latitude 0 and longitude 0 toward
/// +z, longitude pi/2 toward +x, longitudes from pi at the left to -pi at the right.
Vec2 usdDome(const Vec3& ours) {
  const Vec3 d = yUp(ours);
  const double latitude = std::asin(d.y), longitude = std::atan2(d.x, d.z);
  return ofShares(0.5 - longitude / (2.0 * kPi), 0.5 + latitude / kPi);
}

/// UsdLuxDomeLight_1 in a stage with +Z up: latitude 0 and longitude 0 toward -y.
Vec2 usdDomeZUp(const Vec3& ours) {
  const Vec3 d{ours.y, -ours.x, ours.z};  // our sky, turned so that the sun's azimuth is toward -y
  const Vec3 asYUp{d.x, d.z, -d.y};       // the quarter turn about x that takes the pole from y to z, undone
  return ofShares(0.5 - std::atan2(asYUp.x, asYUp.z) / (2.0 * kPi), 0.5 + std::asin(asYUp.y) / kPi);
}

/// OpenEXR's own function, which puts centres of pixels at the borders of the sphere: up to half a pixel aside.
Vec2 openExr(const Vec3& ours) {
  const Vec3 d = yUp(ours);
  const Imath::Box2i window({0, 0}, {kWidth - 1, kHeight - 1});
  const Imath::V2f centre = Imf::LatLongMap::pixelPosition(
      window, Imath::V3f(static_cast<float>(d.x), static_cast<float>(d.y), static_cast<float>(d.z)));
  return {centre.x + 0.5, centre.y + 0.5};
}

const Program kPrograms[] = {
    {"Blender", blender}, {"USD dome light", usdDome}, {"USD dome light, +Z up", usdDomeZUp}, {"OpenEXR", openExr}};

}  // namespace

TEST_CASE("environment light shows the right parhelion and the circumzenithal arc at the pixels where others look") {
  const Image sky = platesSky();
  const double parhelion = theory::leastTurn(kIndex, kSun), zenithal = theory::circumzenithal(kIndex, kSun);

  // The centre column is the sun's azimuth, rows go from the zenith to the nadir.
  const int column = static_cast<int>((0.5 + parhelion / (2.0 * kPi)) * kWidth);
  const int row = static_cast<int>((0.5 - kSun / kPi) * kHeight),
            arcRow = static_cast<int>((0.5 - zenithal / kPi) * kHeight);
  const Pixel right = brightest(sky, {column - 40, row - 40}, {column + 40, row + 40});
  const Pixel arc = brightest(sky, {kWidth / 6, 20}, {5 * kWidth / 6, row - 40});

  // The edge is where Snell's law says; the pixel beyond it holds more of the light where the edge is near its border.
  CHECK(right.y == row);
  CHECK((right.x == column || right.x == column + 1));
  CHECK(arc.y == arcRow);
  CHECK(at(sky, {kWidth - 1 - right.x, row}) < 0.01F * at(sky, right));

  for (const Program& program : kPrograms) {
    CAPTURE(program.name);
    const Vec2 p = program.pixelOf(toSky({parhelion, kSun}));
    CHECK(std::abs(p.x - right.x) <= 1.0);
    CHECK(static_cast<int>(p.y) == right.y);
    CHECK(static_cast<int>(program.pixelOf(toSky({0.0, zenithal})).y) == arc.y);
    // The sun's azimuth is the centre of the picture, to the half pixel between centres and borders.
    CHECK(std::abs(program.pixelOf(toSky({0.0, kSun})).x - 0.5 * kWidth) < 1e-4);
    CHECK(program.pixelOf(toSky({radians(90), 0.0})).x == doctest::Approx(0.75 * kWidth).epsilon(0.001));
  }
}

TEST_CASE("the plates of the test for environment light make the parhelion to the observer's right, toward -y") {
  double right = 0.0, left = 0.0;
  const double parhelion = degrees(theory::leastTurn(kIndex, kSun));
  forDirectLight(oneSidedPlates(), 100'000, [&](const DirectLight& light) {
    const bool isParhelion = std::abs(std::abs(seenAt(light.lightDirWorld).azimuth) - parhelion - 0.5) < 0.5;
    if (isParhelion) (-light.lightDirWorld.y < 0.0 ? right : left) += light.energy;
  });
  CHECK(right > 0.01 * 100'000);
  CHECK(left == 0.0);
}
