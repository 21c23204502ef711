// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "sky/camera.h"
#include "sky/look_at.h"
#include "sky/picture_error.h"
#include "sky/radiance.h"

using namespace parhelion;
using namespace parhelion::test;

namespace {

/// A narrow view, so that all pixels are nearly of one size, with so many hits of unit light in each pixel.
Tally tallyOf(int hits, int pixels = 100) {
  TallyInfo info;
  info.camera = lookAt(Projection::rectilinear, 0.0, 30.0, 0.0, 2.0, 10, 10);
  Tally tally(info, 1);
  for (int pixel = 0; pixel < pixels; ++pixel)
    for (int hit = 0; hit < hits; ++hit) tally.add(pixel, Vec3(1.0), hit % 2 == 0);
  tally.info.intercepted.add(1e6);
  tally.info.rays = {{0, 1'000'000}};
  return tally;
}

}  // namespace

TEST_CASE("with n hits in each pixel the error of the plain picture is 1 / sqrt(n)") {
  for (const int hits : {1, 25, 400})
    CHECK(plainError(tallyOf(hits)) == doctest::Approx(1.0 / std::sqrt(hits)).epsilon(1e-3).scale(0));
}

TEST_CASE("a pixel that nothing hit is not known to be dark: it has the error of one hit") {
  // Of 100 pixels 20 have 4 hits each: their errors are 20 times 2, those of the others 80 times 1, the light is 80.
  CHECK(plainError(tallyOf(4, 20)) == doctest::Approx((40.0 + 80.0) / 80.0).epsilon(1e-3).scale(0));
}

TEST_CASE("an estimate of the bias counts as far as the plain picture allows it") {
  const Tally tally = tallyOf(100);
  Image sky = plainRadiance(tally);
  const double plain = plainError(tally), radiance = (*sky.rgb()[0])[0];
  sky.add(kBiasChannel);
  auto& bias = sky.channels.back().samples;
  std::fill(bias.begin(), bias.end(), static_cast<float>(0.05 * radiance));
  // Where both agree, the plain picture's error is as good a bound, and a smaller one.
  CHECK(pictureError(sky, tally) == doctest::Approx(plain).epsilon(1e-3).scale(0));
  // A smooth picture that has no noise and is 5 % too bright is known to be off by no more than that and the noise.
  for (const char* name : {"R", "G", "B"})
    for (float& sample : const_cast<std::vector<float>&>(*sky.find(name))) sample *= 1.05F;
  for (float& sample : const_cast<std::vector<float>&>(*sky.find(kVarianceChannel))) sample = 0.0F;
  CHECK(pictureError(sky, tally) == doctest::Approx(0.05 / 1.05).epsilon(1e-3).scale(0));
  std::fill(bias.begin(), bias.end(), static_cast<float>(50.0 * radiance));
  CHECK(pictureError(sky, tally) == doctest::Approx(0.15 / 1.05).epsilon(1e-3).scale(0));
}

TEST_CASE("a picture without light has no error that is small enough") {
  CHECK(plainError(tallyOf(0)) == std::numeric_limits<double>::infinity());
  CHECK_THROWS_AS(pictureError(Image{3, 3, {}}, tallyOf(1)), std::invalid_argument);
}
