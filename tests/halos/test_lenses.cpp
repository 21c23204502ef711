// SPDX-License-Identifier: Apache-2.0
// One sky through several lenses.
#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "halos/experiment.h"
#include "math/names.h"
#include "sky/camera.h"
#include "trace/expose.h"

using namespace parhelion;

namespace {

constexpr double kSun = radians(20);
constexpr std::uint64_t kRays = 200'000;

Tally seenBy(const CameraSettings& camera, std::uint64_t seed) {
  TallyInfo info;
  info.seed = seed;
  info.white = {1.0, 1.0, 1.0};
  info.sunElevation = kSun;
  info.camera = camera;
  SkyTally tally(info, 1, {TallySymmetry::mirror});
  const Cloud cloud = cloudUnderPointSun(kSun, {prisms(1.0, RandomOrientation{})});
  traceTally(tally, cloud, {.rays = kRays, .seed = seed, .symmetry = Symmetry::mirror});
  return tally.parts().front().tally;
}

CameraSettings lens(Projection projection, int width, int height) {
  CameraSettings camera;
  camera.projection = projection;
  camera.azimuth = radians(30);
  camera.elevation = radians(25);
  camera.roll = radians(10);
  camera.fieldOfView = projection == Projection::equirectangular ? 2.0 * kPi : kPi;
  camera.width = width;
  camera.height = height;
  return camera;
}

double lightOf(const Tally& tally) {
  double sum = 0.0;
  for (int p = 0; p < tally.pixels(); ++p) sum += tally.luminance(p);
  return sum;
}

}  // namespace

TEST_CASE("a dual fisheye receives the radiance that a panorama does, and all of the sky's light") {
  const Tally panorama = seenBy(lens(Projection::equirectangular, 1440, 720), 1);
  const Camera view(panorama.info.camera);
  for (const Projection projection : {Projection::dualFisheyeEqualArea, Projection::dualFisheyeOrthographic}) {
    CAPTURE(std::string(nameOf(projection)));
    CHECK(lightOf(seenBy(lens(projection, 40, 20), 1)) == doctest::Approx(lightOf(panorama)).epsilon(1e-8));

    // Of other rays: each large pixel against what the panorama has in its place.
    const Tally dual = seenBy(lens(projection, 40, 20), 2);
    const Camera camera(dual.info.camera);
    std::vector<double> light(static_cast<std::size_t>(dual.pixels())), squares(light.size()), edge(light.size());
    for (int y = 0; y < 720; ++y) {
      for (int x = 0; x < 1440; ++x) {
        const auto pixel = camera.pixelAt(*view.toSky({x + 0.5, y + 0.5}));
        if (!pixel) continue;
        const double here = panorama.luminance(y * 1440 + x), error = panorama.luminanceError(y * 1440 + x);
        light[static_cast<std::size_t>(*pixel)] += here;
        squares[static_cast<std::size_t>(*pixel)] += error * error;
        // A small pixel on the border of a large one is taken whole: off by 0.3 of itself.
        for (const Vec2& corner : {Vec2(0.0), Vec2(1.0, 0.0), Vec2(0.0, 1.0), Vec2(1.0)}) {
          if (camera.pixelAt(*view.toSky(Vec2(x, y) + corner)) == pixel) continue;
          squares[static_cast<std::size_t>(*pixel)] += 0.1 * here * here;
          break;
        }
      }
    }
    double sum = 0.0;
    int pixels = 0;
    for (int p = 0; p < dual.pixels(); ++p) {
      const double there = light[static_cast<std::size_t>(p)], error = dual.luminanceError(p);
      if (dual.hits(p) < 50 || there == 0.0) continue;
      const double difference = dual.luminance(p) - there;
      sum += difference * difference / (squares[static_cast<std::size_t>(p)] + error * error);
      ++pixels;
    }
    CHECK(pixels > 300);
    CHECK(std::abs(sum - pixels) < 5.0 * std::sqrt(2.0 * pixels));
  }
}

TEST_CASE("a camera without ground receives the light of one with it in all pixels above the horizon, and no other") {
  CameraSettings settings = lens(Projection::rectilinear, 60, 40);
  settings.fieldOfView = radians(100.0);
  const Tally whole = seenBy(settings, 1);
  settings.horizon = Horizon::cut;
  const Tally cut = seenBy(settings, 1);
  const Camera camera(settings);
  int onHorizon = 0, below = 0;
  for (int p = 0; p < cut.pixels(); ++p) {
    double lowest = 1.0, highest = -1.0;
    for (const Vec2& corner : {Vec2(0.0), Vec2(1.0, 0.0), Vec2(0.0, 1.0), Vec2(1.0)}) {
      CameraSettings all = settings;
      all.horizon = Horizon::keep;
      const double z = Camera(all).toSky(Vec2(p % 60, p / 60) + corner)->z;
      lowest = std::min(lowest, z);
      highest = std::max(highest, z);
    }
    if (lowest > 0.0) {
      CHECK(cut.raw(p, Tally::kY) == whole.raw(p, Tally::kY));
    } else if (highest < 0.0) {
      ++below;
      CHECK(cut.raw(p, Tally::kY) == 0);
    } else {
      ++onHorizon;
      CHECK(cut.luminance(p) <= whole.luminance(p));
    }
  }
  CHECK(below > 20);
  CHECK(onHorizon > 20);
  CHECK(cut.info.intercepted == whole.info.intercepted);
}
