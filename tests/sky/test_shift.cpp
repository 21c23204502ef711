// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string>

#include <glm/geometric.hpp>

#include "math/names.h"
#include "sky/camera.h"
#include "sky/look_at.h"
#include "sky/radial_skies.h"

namespace parhelion {
namespace {

constexpr std::array kLenses = {Projection::rectilinear, Projection::fisheyeEqualArea, Projection::fisheyeEquidistant,
                                Projection::fisheyeStereographic, Projection::fisheyeOrthographic};

/// A picture 300 x 200 that is cut from a larger one: its shift makes it see the same.
struct Cut {
  CameraSettings whole, part;
  Vec2 corner;  // of the part in the whole, pixels
};

Cut cut(Projection projection) {
  Cut c;
  c.whole = test::lookAt(projection, 20.0, 15.0, 33.0, 100.0, 600, 500);
  c.part = c.whole;
  c.part.width = 300;
  c.part.height = 200;
  c.corner = {290.0, 17.0};
  const Camera whole(c.whole);
  // The same focal length, whatever the projection makes of half the width.
  double lo = radians(1.0), hi = radians(100.0);
  for (int i = 0; i < 100; ++i) {
    c.part.fieldOfView = 0.5 * (lo + hi);
    (Camera(c.part).focalLength() > whole.focalLength() ? lo : hi) = c.part.fieldOfView;
  }
  const Vec2 centre = c.corner + Vec2(150.0, 100.0) - whole.axis();
  c.part.shift = {centre.x / whole.focalLength(), -centre.y / whole.focalLength()};
  return c;
}

}  // namespace

TEST_CASE("a shifted picture is a piece of a larger one that is not") {
  for (const Projection projection : kLenses) {
    CAPTURE(std::string(nameOf(projection)));
    const Cut c = cut(projection);
    const Camera whole(c.whole), part(c.part);
    CHECK_FALSE(part.isMirrorSymmetric());
    for (double y = 3.0; y < 200.0; y += 19.0) {
      for (double x = 2.0; x < 300.0; x += 23.0) {
        const auto toSky = part.toSky({x, y}), same = whole.toSky(c.corner + Vec2(x, y));
        REQUIRE(toSky);
        REQUIRE(same);
        CHECK(glm::length(*toSky - *same) < 1e-9);
        const auto back = part.project(*toSky);
        REQUIRE(back);
        CHECK(glm::length(*back - Vec2(x, y)) < 1e-7);
        const int px = static_cast<int>(x), py = static_cast<int>(y);
        CHECK(part.solidAngle(px, py) == doctest::Approx(whole.solidAngle(px + 290, py + 17)).epsilon(1e-9));
      }
    }
    const std::vector<double> all = part.solidAngles();
    CHECK(all[7 * 300 + 11] == part.solidAngle(11, 7));
    CHECK(all[7 * 300 + 288] == part.solidAngle(288, 7));
  }
}

TEST_CASE("a shift upward shows more of what is above, the horizon of a level camera stays straight") {
  CameraSettings s = test::lookAt(Projection::rectilinear, 0.0, 0.0, 0.0, 60.0, 300, 200);
  s.shift.y = 0.2;
  const Camera camera(s);
  const double focal = camera.focalLength();
  const auto ahead = camera.project({1.0, 0.0, 0.0});
  REQUIRE(ahead);
  CHECK(ahead->x == doctest::Approx(150.0));
  CHECK(ahead->y == doctest::Approx(100.0 + 0.2 * focal));
  CHECK(camera.isMirrorSymmetric());
  s.shift = {0.2, 0.0};
  CHECK(Camera(s).project({1.0, 0.0, 0.0})->x == doctest::Approx(150.0 - 0.2 * focal));
  CHECK_FALSE(Camera(s).isMirrorSymmetric());
}

TEST_CASE("a radial sky is the same in a shifted picture as in the larger one it is cut from") {
  for (const Projection projection : kLenses) {
    CAPTURE(std::string(nameOf(projection)));
    const Cut c = cut(projection);
    TallyInfo whole, part;
    whole.camera = c.whole;
    part.camera = c.part;
    const auto spreadOf = [](const TallyInfo& i) {
      RadialSky sky(i, kSun, 1);
      // Smooth, and the same whatever the rings.
      for (int bin = 0; bin < sky.bins(); ++bin)
        sky.add(bin, Vec3(100.0 * sky.solidAngle(bin) * (2.0 + std::cos(6.0 * bin / sky.bins()))), false);
      return spread(sky, i);
    };
    const Tally one = spreadOf(whole), other = spreadOf(part);
    for (int y = 0; y < 200; y += 7)
      for (int x = 0; x < 300; x += 7)
        CHECK(other.luminance(y * 300 + x) == doctest::Approx(one.luminance((y + 17) * 600 + x + 290)).epsilon(1e-3));
  }
}

TEST_CASE("a fisheye's circle moves with its axis, and its pixels still add up to what it covers") {
  CameraSettings s = test::lookAt(Projection::fisheyeEquidistant, 0.0, 90.0, 0.0, 400.0 / 300.0 * 180.0, 400, 400);
  s.imageCircle = kPi;
  s.shift = {0.4, -0.3};
  const Camera camera(s);
  const std::vector<double> all = camera.solidAngles();
  CHECK(std::accumulate(all.begin(), all.end(), 0.0) == doctest::Approx(2.0 * kPi).epsilon(1e-10));
}

TEST_CASE("a shift is refused where there is no lens to shift, and where it leaves nothing to see") {
  for (const Projection projection : kMembersOf<Projection>) {
    CAPTURE(std::string(nameOf(projection)));
    CameraSettings s = test::lookAt(projection, 0.0, 30.0, 0.0, showsHemispheres(projection) ? 180.0 : 100.0);
    CHECK_NOTHROW(Camera{s});
    s.shift = {0.1, 0.2};
    if (isPanorama(projection) || showsHemispheres(projection))
      CHECK_THROWS_AS(Camera{s}, std::invalid_argument);
    else
      CHECK_NOTHROW(Camera{s});
    s.shift.x = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_AS(Camera{s}, std::invalid_argument);
  }
  CameraSettings away = test::lookAt(Projection::fisheyeOrthographic, 0.0, 30.0, 0.0, 100.0);
  away.shift = {0.0, 3.0};
  CHECK_THROWS_AS(Camera{away}, std::invalid_argument);
  away.projection = Projection::rectilinear;
  CHECK_NOTHROW(Camera{away});
}

}  // namespace parhelion
