// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>

#include "sky/camera.h"
#include "sky/radiance.h"

namespace parhelion {
namespace {

TallyInfo allSky() {
  TallyInfo info;
  info.camera.width = info.camera.height = 64;
  info.rays = {{0, 1000}};
  info.intercepted = LightTotal(toFixed(1000.0));
  info.white = {0.97, 1.0, 1.05};
  return info;
}

}  // namespace

TEST_CASE("radiance is light over intercepted light and solid angle, the sun's colour is white") {
  Tally tally(allSky());
  const int pixel = 32 * 64 + 20;
  for (int i = 0; i < 50; ++i) tally.add(pixel, 0.5 * tally.info.white, i % 2 == 0);
  const Image image = plainRadiance(tally);
  const double omega = Camera(tally.info.camera).solidAngle(20, 32);
  const double expected = 25.0 / (1000.0 * omega);
  for (const auto* plane : image.rgb()) CHECK((*plane)[pixel] == doctest::Approx(expected).epsilon(1e-6).scale(0.0));
  const double variance = (12.5 - 25.0 * 25.0 / 1000.0) / (1e6 * omega * omega);
  CHECK((*image.find(kVarianceChannel))[pixel] == doctest::Approx(variance).epsilon(1e-6).scale(0.0));
  CHECK((*image.find("G"))[pixel + 1] == 0.0F);
}

TEST_CASE("one colour gives a grey picture, no rays give a black one, corners without sky stay black") {
  Tally tally(allSky(), 1);
  tally.add(32 * 64 + 20, {9.0, 1.0, 9.0}, true);
  tally.add(0, Vec3(1.0), true);  // a corner, outside the image circle
  const Image image = plainRadiance(tally);
  const auto [r, g, b] = image.rgb();
  CHECK(*r == *g);
  CHECK(*g == *b);
  CHECK((*g)[32 * 64 + 20] > 0.0F);
  CHECK((*g)[0] == 0.0F);
  TallyInfo none = allSky();
  none.rays.clear();
  none.intercepted = {};
  for (const Channel& channel : plainRadiance(Tally(none)).channels) {
    for (const float sample : channel.samples) CHECK(sample == 0.0F);
  }
}

TEST_CASE("a pixel that no ray hit has the variance of one typical deposit, one without sky has none") {
  Tally tally(allSky(), 1);
  const int pixel = 32 * 64 + 20;
  for (int i = 0; i < 3; ++i) tally.add(pixel, Vec3(0.5), i % 2 == 0);
  const Image image = plainRadiance(tally);
  const std::vector<float>& variance = *image.find(kVarianceChannel);
  const double perLight = 1.0 / (1000.0 * Camera(tally.info.camera).solidAngle(21, 32));
  CHECK(variance[pixel + 1] == doctest::Approx(0.25 * perLight * perLight).epsilon(1e-6).scale(0.0));
  CHECK((*image.find("G"))[pixel + 1] == 0.0F);
  CHECK(variance[0] == 0.0F);
}

}  // namespace parhelion
