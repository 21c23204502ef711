// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <tbb/global_control.h>

#include "landscapes.h"
#include "math/conventions.h"
#include "painting.h"
#include "photo/find_sky.h"

namespace parhelion {

namespace {

constexpr double kLeastOverlap = 0.97;  // intersection over union

void skyIsFound(Landscape kind) {
  for (const auto& [seed, width, height] : {std::array{1, 400, 300}, {2, 320, 240}}) {
    const Scenery scenery = paintLandscape(kind, static_cast<std::uint64_t>(seed), width, height);
    const double found = overlap(scenery.sky, findSky(scenery.picture).sky);
    CAPTURE(nameOf(kind));
    CAPTURE(width);
    CHECK(found >= kLeastOverlap);
  }
}

template <class F>
Image painted(int width, int height, const F& colourAt) {
  Canvas canvas(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) canvas.colours[canvas.index(x, y)] = colourAt(x, y);
  }
  Dice dice(3);
  return exposed(canvas, dice, 0.1, 0.01);
}

// Blue with white clouds, and no land.
Image cloudySky(int width, int height, bool circle) {
  Dice dice(5);
  const FractalNoise noise(dice);
  return painted(width, height, [&](int x, int y) -> Colour {
    const double u = 2.0 * (x + 0.5) / height - static_cast<double>(width) / height, v = 2.0 * (y + 0.5) / height - 1.0;
    if (circle && std::hypot(u, v) > 0.98) return {0.0, 0.0, 0.0};
    const double cover = std::clamp(3.0 * noise.at(2.0 * u, 2.0 * v, 5) - 0.3, 0.0, 1.0);
    return mix({0.15, 0.3, 0.6}, {0.8, 0.8, 0.82}, cover);
  });
}

double shareOfSky(const SkyMask& mask) {
  double sum = 0.0;
  for (const std::uint8_t sky : mask.sky) sum += sky / 255.0;
  return sum / static_cast<double>(mask.sky.size());
}

// Whether all of a window is sky, or all is land.
bool farFromEdge(const Scenery& scenery, int x, int y, int reach) {
  const Image& picture = scenery.picture;
  const auto at = [&](int i, int j) {
    i = std::clamp(i, 0, picture.width - 1);
    j = std::clamp(j, 0, picture.height - 1);
    return scenery
        .sky[static_cast<std::size_t>(j) * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(i)];
  };
  for (int dy = -reach; dy <= reach; dy += 2) {
    for (int dx = -reach; dx <= reach; dx += 2) {
      if (at(x + dx, y + dy) != at(x, y)) return false;
    }
  }
  return true;
}

}  // namespace

TEST_CASE("the sky above ridges is found") { skyIsFound(Landscape::ridges); }
TEST_CASE("the sky above ridges in haze is found") { skyIsFound(Landscape::haze); }
TEST_CASE("the sky between the branches of bare trees is found") { skyIsFound(Landscape::bareTrees); }
TEST_CASE("the sky behind trees with leaves is found") { skyIsFound(Landscape::leafyTrees); }
TEST_CASE("a sky of bright clouds is found") { skyIsFound(Landscape::brightClouds); }
TEST_CASE("a sky of dark clouds is found") { skyIsFound(Landscape::darkClouds); }
TEST_CASE("the sky about a low sun is found") { skyIsFound(Landscape::sunset); }
TEST_CASE("snow as bright as the sky is not sky") { skyIsFound(Landscape::snow); }
TEST_CASE("a lake that mirrors the sky is not sky") { skyIsFound(Landscape::lake); }
TEST_CASE("the sky above the sea is found") { skyIsFound(Landscape::sea); }
TEST_CASE("the sky above a town is found") { skyIsFound(Landscape::town); }

TEST_CASE("the sky is found in a picture of twice the size") {
  const Scenery scenery = paintLandscape(Landscape::haze, 3, 800, 600);
  CHECK(overlap(scenery.sky, findSky(scenery.picture).sky) >= kLeastOverlap);
}

TEST_CASE("a photograph gets a mask of its own size that is exact away from edges") {
  const Scenery scenery = paintLandscape(Landscape::ridges, 3, 1600, 1200);
  const SkyMask mask = findSky(photographOf(scenery.picture));
  REQUIRE(mask.width == 1600);
  REQUIRE(mask.height == 1200);
  CHECK(overlap(scenery.sky, mask.sky) >= kLeastOverlap);
  // The filter reaches 14 pixels of the half-size picture; halos on the land die out sooner.
  constexpr int kExact = 30, kNear = 8;
  double leak = 0.0, land = 0.0;
  int notExact = 0;
  for (int y = 0; y < mask.height; y += 3) {
    for (int x = 0; x < mask.width; x += 3) {
      const auto i = static_cast<std::size_t>(y) * 1600 + static_cast<std::size_t>(x);
      if (scenery.sky[i] == 0.0F && farFromEdge(scenery, x, y, kNear)) {
        land += 1.0;
        leak += mask.sky[i] / 255.0;
      }
      if (farFromEdge(scenery, x, y, kExact)) notExact += mask.sky[i] != (scenery.sky[i] > 0.5F ? 255 : 0);
    }
  }
  REQUIRE(land > 0.0);
  CHECK(leak / land < 0.02);
  CHECK(notExact == 0);
}

TEST_CASE("branches finer than the reduced picture are found in the photograph") {
  const Scenery scenery = paintLandscape(Landscape::bareTrees, 2, 1600, 1200);
  CHECK(overlap(scenery.sky, findSky(photographOf(scenery.picture)).sky) >= kLeastOverlap);
}

TEST_CASE("a picture of nothing but sky is all sky") { CHECK(shareOfSky(findSky(cloudySky(400, 300, false))) == 1.0); }

TEST_CASE("the black corners of a fisheye picture are not sky") {
  const SkyMask mask = findSky(cloudySky(300, 300, true));
  CHECK(mask.sky.front() == 0);
  CHECK(mask.sky.back() == 0);
  const double circle = kPi / 4.0 * 0.98 * 0.98;
  const double rim = kPi * 4.0 / 300.0;  // 4 pixels about the circle
  CHECK(std::abs(shareOfSky(mask) - circle) < rim);
}

TEST_CASE("a picture of leaves has no sky") {
  Dice dice(11);
  const FractalNoise noise(dice);
  const Image leaves = painted(400, 300, [&](int x, int y) {
    return scaled({0.12, 0.25, 0.06}, std::max(0.1, 1.0 + 1.2 * noise.at(x / 12.0, y / 12.0, 3)));
  });
  CHECK(shareOfSky(findSky(leaves)) == 0.0);
}

TEST_CASE("pictures of a pixel, a row and one colour are no trouble") {
  for (const auto& [width, height] : {std::array{1, 1}, {700, 1}, {1, 700}, {50, 40}}) {
    const SkyMask mask = findSky(painted(width, height, [](int, int) { return Colour{0.0, 0.0, 0.0}; }));
    CHECK(mask.sky.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  }
}

TEST_CASE("the sky does not depend on the unit of light") {
  const Scenery scenery = paintLandscape(Landscape::haze, 4, 320, 240);
  Image brighter = scenery.picture;
  // A power of two changes no digit.
  for (Channel& channel : brighter.channels) {
    for (float& sample : channel.samples) sample *= 4096.0F;
  }
  CHECK(findSky(brighter) == findSky(scenery.picture));
}

TEST_CASE("the sky has the same bits for any number of threads") {
  const Photograph photograph = photographOf(paintLandscape(Landscape::leafyTrees, 3, 1200, 900).picture);
  const auto with = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return findSky(photograph);
  };
  CHECK(with(1) == with(4));
}

}  // namespace parhelion
