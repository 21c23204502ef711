// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>
#include <numeric>
#include <optional>
#include <string>

#include <glm/geometric.hpp>

#include "math/names.h"
#include "math/rotation.h"
#include "sky/camera.h"
#include "sky/isotropic_light.h"
#include "sky/look_at.h"
#include "sky/radial_skies.h"
#include "sky/tally_info_text.h"

namespace parhelion {
namespace {

CameraSettings above(Projection projection, double azimuth, double elevation, double roll, int width, int height) {
  const double fieldOfView = showsHemispheres(projection) || projection == Projection::fisheyeOrthographic ? 180.0
                             : projection == Projection::rectilinear                                       ? 110.0
                             : isPanorama(projection)                                                      ? 360.0
                                                                                                           : 180.0;
  CameraSettings s = test::lookAt(projection, azimuth, elevation, roll, fieldOfView, width, height);
  s.horizon = Horizon::cut;
  return s;
}

CameraSettings uncut(CameraSettings s) {
  s.horizon = Horizon::keep;
  return s;
}

double total(const CameraSettings& s) {
  const std::vector<double> all = Camera(s).solidAngles();
  return std::accumulate(all.begin(), all.end(), 0.0);
}

}  // namespace

TEST_CASE("a camera that sees the whole sky sees half of it above the horizon, however it is turned") {
  for (const Projection projection :
       {Projection::equirectangular, Projection::dualFisheyeEqualArea, Projection::dualFisheyeEquidistant,
        Projection::dualFisheyeStereographic, Projection::dualFisheyeOrthographic}) {
    for (const auto& [elevation, roll] :
         {std::pair(0.0, 0.0), {90.0, 0.0}, {-90.0, 12.0}, {20.0, 50.0}, {89.99, 7.0}}) {
      for (const int height : {2, 9, 128}) {
        CAPTURE(std::string(nameOf(projection)));
        CAPTURE(elevation);
        CAPTURE(height);
        CHECK(total(above(projection, 33.0, elevation, roll, 2 * height, height)) ==
              doctest::Approx(2.0 * kPi).epsilon(1e-7));
      }
    }
  }
  for (const double circle : {360.0, 300.0}) {
    CameraSettings whole = above(Projection::fisheyeEquidistant, 0.0, 0.0, 10.0, 64, 64);
    whole.fieldOfView = whole.imageCircle = radians(circle);
    CHECK(total(whole) == doctest::Approx(kPi * (1.0 - std::cos(radians(0.5 * circle)))).epsilon(1e-7));
  }
}

TEST_CASE("the hemisphere of a fisheye is cut in proportion to its tilt") {
  for (const Projection projection :
       {Projection::fisheyeEqualArea, Projection::fisheyeEquidistant, Projection::fisheyeStereographic,
        Projection::fisheyeOrthographic, Projection::globe}) {
    for (const double elevation : {90.0, 89.9, 60.0, 5.0, 0.0, -30.0, -90.0}) {
      for (const int size : {1, 5, 200, 400}) {
        CAPTURE(std::string(nameOf(projection)));
        CAPTURE(elevation);
        CAPTURE(size);
        // Two hemispheres whose axes are the complement of the elevation apart share a lune.
        const double lune = 2.0 * (0.5 * kPi + radians(elevation));
        CHECK(std::abs(total(above(projection, 12.0, elevation, 71.0, size, size)) - lune) < 1e-6);
      }
    }
  }
}

TEST_CASE("isotropic light falls into each pixel by its solid angle above the horizon, none below") {
  for (const Projection projection : kMembersOf<Projection>) {
    for (const double roll : {0.0, 40.0}) {
      CAPTURE(std::string(nameOf(projection)));
      const Camera camera(above(projection, 20.0, roll == 0.0 ? 0.0 : 11.0, roll, 30, 15));
      test::checkIsotropicLight(camera, [](const Vec3& toSky, std::optional<int> pixel) {
        if (toSky.z < 0.0) CHECK_FALSE(pixel);
      });
    }
  }
}

TEST_CASE("pixels above the horizon are as without it, those below show no sky") {
  for (const Projection projection : kMembersOf<Projection>) {
    CAPTURE(std::string(nameOf(projection)));
    CameraSettings s = above(projection, 20.0, 11.0, 40.0, 60, 30);
    if (!isPanorama(projection) && !showsHemispheres(projection)) s.shift = {0.1, -0.2};
    const Camera cut(s), whole(uncut(s));
    int seen = 0;
    for (int y = 0; y < 30; ++y) {
      for (int x = 0; x < 60; ++x) {
        double lowest = 1.0, highest = -1.0;
        for (const Vec2& at : {Vec2(0.0), Vec2(1.0), Vec2(0.0, 1.0), Vec2(1.0, 0.0), Vec2(0.5)}) {
          const auto toSky = whole.toSky(Vec2(x, y) + at);
          if (!toSky) continue;
          lowest = std::min(lowest, toSky->z);
          highest = std::max(highest, toSky->z);
          if (std::abs(toSky->z) > 1e-9) CHECK(cut.toSky(Vec2(x, y) + at).has_value() == (toSky->z > 0.0));
        }
        const double expected = whole.solidAngle(x, y);
        CHECK(cut.solidAngle(x, y) <= expected * (1.0 + 1e-7));
        if (highest >= lowest && lowest > 0.03) CHECK(cut.solidAngle(x, y) == doctest::Approx(expected).epsilon(1e-7));
        if (highest >= lowest && highest < -0.03) CHECK(cut.solidAngle(x, y) < 1e-9);
        ++seen;
      }
    }
    CHECK(seen == 1800);
  }
}

TEST_CASE("pixels cut by the horizon have the share that a fine grid finds above it") {
  for (const Projection projection : kMembersOf<Projection>) {
    CAPTURE(std::string(nameOf(projection)));
    const CameraSettings s = above(projection, 20.0, 4.0, 20.0, 40, 20);
    CameraSettings fine = uncut(s);
    constexpr int kFiner = 50;
    fine.width *= kFiner;
    fine.height *= kFiner;
    const Camera cut(s), grid(fine);
    for (int y = 0; y < 20; ++y) {
      for (int x = y % 3; x < 40; x += 3) {
        const double whole = Camera(uncut(s)).solidAngle(x, y), part = cut.solidAngle(x, y);
        if (part == 0.0 || std::abs(part - whole) < 1e-9 * whole) continue;
        double sum = 0.0;
        for (int v = 0; v < kFiner; ++v) {
          for (int u = 0; u < kFiner; ++u) {
            const int gx = x * kFiner + u, gy = y * kFiner + v;
            // Of a cell on the rim a corner decides.
            std::optional<Vec3> toSky;
            for (const Vec2& at : {Vec2(0.5), Vec2(0.0), Vec2(1.0), Vec2(0.0, 1.0), Vec2(1.0, 0.0)})
              if (!toSky) toSky = grid.toSky(Vec2(gx, gy) + at);
            if (toSky && toSky->z > 0.0) sum += grid.solidAngle(gx, gy);
          }
        }
        // A line across 50 cells is misjudged by about half the root of their number.
        CHECK(std::abs(part - sum) < 0.01 * whole + 1e-9);
      }
    }
  }
}

TEST_CASE("an even radial sky gives light by solid angle up to a horizon that is cut, and none below") {
  for (const Projection projection : kMembersOf<Projection>) {
    CAPTURE(std::string(nameOf(projection)));
    TallyInfo i;
    i.camera = above(projection, 20.0, 11.0, 40.0, 60, 30);
    checkEvenRadialSky(i);
  }
}

TEST_CASE("a pixel that the image circle or the horizon touches in a corner shows no sky") {
  // A circle of radius 200 goes through corners of pixels, such as 56, 192.
  for (const Projection projection : kMembersOf<Projection>) {
    CAPTURE(std::string(nameOf(projection)));
    for (const Horizon horizon : {Horizon::keep, Horizon::cut}) {
      CameraSettings s =
          above(projection, 0.0, horizon == Horizon::cut ? 0.0 : 90.0, 0.0, discs(projection) * 400, 400);
      s.horizon = horizon;
      const std::vector<double> all = Camera(s).solidAngles();
      double smallest = 1.0;
      for (const double omega : all)
        if (omega > 0.0) smallest = std::min(smallest, omega);
      CHECK(smallest > 1e-7 * total(s) / static_cast<double>(all.size()));
    }
  }
}

TEST_CASE("tallies from before there was a horizon to cut are read, and those of whole cameras are the same") {
  TallyInfo info;
  const ExrAttributes usual = textFromInfo(info);
  for (const auto& [key, entry] : usual) {
    CHECK(key.find("horizon") == std::string::npos);
    CHECK(key.find("shift") == std::string::npos);
  }
  info.camera.horizon = Horizon::cut;
  info.camera.shift = {0.25, -1.0 / 3.0};
  CHECK(infoFromText(textFromInfo(info)).camera == info.camera);
  ExrAttributes wrong = textFromInfo(info);
  wrong["camera.horizon"] = "round";
  CHECK_THROWS_AS(infoFromText(wrong), std::invalid_argument);
}

}  // namespace parhelion
