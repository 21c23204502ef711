// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "picture/auto_exposure.h"
#include "picture/tone.h"

namespace parhelion {
namespace {

constexpr int kSide = 200;

/// A grey picture of this luminance.
Image picture(const std::function<double(int, int)>& luminance) {
  Image image{kSide, kSide, {}};
  for (const char* name : {"R", "G", "B"}) {
    auto& plane = image.add(name);
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x)
        plane[static_cast<std::size_t>(y * kSide + x)] = static_cast<float>(luminance(x, y));
  }
  return image;
}

double fromCentre(int x, int y) { return std::hypot(x - 100.0, y - 100.0); }

/// A ring with a sharp inner edge, a parhelion on its right and the sun's disc, over a sky of luminance 1: the
/// contrasts of a display of plates and columns.
double halo(int x, int y) {
  const double r = fromCentre(x, y);
  if (r < 1.5) return 1e5;
  const double parhelion = 360.0 * std::exp(-0.5 * (std::pow(x - 162.0, 2) + std::pow(y - 100.0, 2)) / 2.0);
  return 1.0 + parhelion + (r < 60.0 ? 0.0 : 16.0 * std::exp((60.0 - r) / 10.0));
}

/// The code value at a place of the developed picture, from 0 to 255.
int codeAt(const Preview& preview, int x, int y) { return preview.rgb[static_cast<std::size_t>(3 * (y * kSide + x))]; }

}  // namespace

TEST_CASE("at the chosen exposure the ring's inner edge and the parhelion can both be read") {
  const Image image = picture(halo);
  const Preview preview = developPreview(image, {autoExposure(image)});
  const int sky = codeAt(preview, 100, 50), ring = codeAt(preview, 100, 38), parhelion = codeAt(preview, 162, 100);
  CHECK(sky > 20);
  CHECK(sky < 80);
  CHECK(ring > sky + 60);
  CHECK(parhelion > ring + 40);
  CHECK(parhelion < 250);
}

TEST_CASE("twice the light is exposed one stop less") {
  const double once = autoExposure(picture(halo));
  for (const double stops : {-20.0, 1.0, 30.0})
    CHECK(autoExposure(picture([&](int x, int y) { return std::exp2(stops) * halo(x, y); })) ==
          doctest::Approx(once - stops).epsilon(1e-9));
}

TEST_CASE("black corners, bad pixels and how much plain sky there is do not change the exposure") {
  const double whole = autoExposure(picture(halo));
  const Image circle = picture([](int x, int y) { return fromCentre(x, y) < 95.0 ? halo(x, y) : 0.0; });
  CHECK(std::abs(autoExposure(circle) - whole) < 0.1);
  Image bad = picture(halo);
  for (Channel& channel : bad.channels) {
    channel.samples[500] = std::nanf("");
    channel.samples[900] = INFINITY;
    channel.samples[1300] = -1e6F;
  }
  CHECK(std::abs(autoExposure(bad) - whole) < 0.02);
  const Image bright = picture([](int x, int y) { return y > 180 ? 17.0 : halo(x, y); });  // brightens the mean only
  CHECK(std::abs(autoExposure(bright) - whole) < 0.5);
}

TEST_CASE("the disc of the sun does not decide on the exposure") {
  const auto withDisc = [](double luminance) {
    return picture([=](int x, int y) { return fromCentre(x, y) < 5.0 ? luminance : halo(x, y); });
  };
  CHECK(std::abs(autoExposure(withDisc(1e9)) - autoExposure(withDisc(1e3))) < 0.02);
}

TEST_CASE("a picture of one grey comes out as a dark grey, a black one has exposure 0") {
  CHECK(std::abs(autoExposure(picture([](int, int) { return 0.25; })) - (2.0 - 3.0)) < 1.0 / 64.0);
  CHECK(autoExposure(picture([](int, int) { return 0.0; })) == 0.0);
}

}  // namespace parhelion
