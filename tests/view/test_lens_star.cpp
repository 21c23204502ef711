// SPDX-License-Identifier: Apache-2.0
#include "view/lens_star.h"

#include <cmath>
#include <numeric>
#include <string>

#include <doctest/doctest.h>

#include "math/conventions.h"

using namespace parhelion;

namespace {

constexpr int kSize = 401, kMiddle = 200;
constexpr double kPixel = radians(0.1);

/// A dim picture with a white sun in its middle pixel.
Image sunPicture(float sun) {
  Image image{kSize, kSize, {}};
  for (const char* name : {"R", "G", "B"}) {
    std::vector<float>& plane = image.add(name);
    plane.assign(plane.size(), 1e-6F);
    plane[kMiddle * kSize + kMiddle] = sun;
  }
  return image;
}

double at(const Image& image, const char* channel, int x, int y) {
  return static_cast<double>((*image.find(channel))[static_cast<std::size_t>(y * kSize + x)]);
}

}  // namespace

TEST_CASE("a lens with many blades diffracts what the rings of a round aperture hold") {
  // The energy outside of x = k a t, as Bessel functions have it, is 2 / (pi x) on average over the rings.
  const double angle = radians(0.5), x = 2.0 * kPi * 1.0 / 550e-6 * angle;
  CHECK(starShare({1000, 2.0}, 550.0, angle) == doctest::Approx(2.0 / (kPi * x)).epsilon(1e-4));
}

TEST_CASE("a star has a ray square to each edge on either side, brighter the longer the waves are, and keeps light") {
  for (const auto& [blades, rays] : {std::pair{6, 6}, {7, 14}, {8, 8}, {3, 6}}) {
    CAPTURE(blades);
    CHECK(starRays({blades, 2.0}).size() == static_cast<std::size_t>(rays));
  }
  const LensAperture lens{6, 2.0};
  Image image = sunPicture(1.0F);
  CHECK(addLensStar(image, kPixel, lens) == 1);
  // Six rays, one of them down; between them there is nothing.
  CHECK(at(image, "G", kMiddle, kMiddle + 50) > 3e-6);
  CHECK(at(image, "G", kMiddle, kMiddle - 50) == doctest::Approx(at(image, "G", kMiddle, kMiddle + 50)).epsilon(1e-3));
  CHECK(at(image, "G", kMiddle + 50, kMiddle) == doctest::Approx(1e-6));
  // Along a ray light falls with the square of the distance, and goes with the wavelength.
  const auto ray = [&](const char* channel, int distance) {
    return at(image, channel, kMiddle, kMiddle + distance) - 1e-6;
  };
  CHECK(ray("G", 25) / ray("G", 50) == doctest::Approx(4.0).epsilon(0.02));
  CHECK(ray("R", 50) / ray("B", 50) == doctest::Approx(611.0 / 464.0).epsilon(1e-3));
  const std::vector<float>& green = *image.find("G");
  const double all = std::accumulate(green.begin(), green.end(), 0.0), before = 1.0 + 1e-6 * (kSize * kSize - 1.0);
  // Four of the rays leave the picture at its sides, 231 pixels away, and two below and above.
  const double left = 2.0 * starShare(lens, 549.0, 200.5 * kPixel) / 6.0 +
                      4.0 * starShare(lens, 549.0, 200.5 / std::cos(radians(30.0)) * kPixel) / 6.0;
  CHECK(before - all == doctest::Approx(left).epsilon(0.02));
}

TEST_CASE("what is not dazzling makes no star") {
  Image image = sunPicture(5e-4F);
  CHECK(addLensStar(image, kPixel) == 0);
  CHECK(at(image, "G", kMiddle, kMiddle) == doctest::Approx(5e-4));
}
