// SPDX-License-Identifier: Apache-2.0
#include "view/glare.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numeric>

#include "math/conventions.h"

using namespace parhelion;

namespace {

double sumOf(const std::vector<float>& plane) { return std::accumulate(plane.begin(), plane.end(), 0.0); }

/// A plane of this size with light 1 in one pixel.
std::vector<float> pointAt(int width, int height, int x, int y) {
  std::vector<float> plane(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  plane[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)] = 1.0F;
  return plane;
}

}  // namespace

TEST_CASE("glare keeps all light that does not leave the picture") {
  const std::vector<BlurredShare> shares{{0.4, 0.2}, {1.5, 0.1}, {4.0, 0.1}, {11.0, 0.2}, {40.0, 0.1}};
  for (const auto& [x, y] : {std::pair{300, 300}, {301, 300}, {307, 290}}) {
    std::vector<float> plane = pointAt(601, 597, x, y);
    spreadLight(plane, 601, 597, shares);
    CHECK(sumOf(plane) == doctest::Approx(1.0).epsilon(1e-5));
    CHECK(plane[static_cast<std::size_t>(y) * 601 + static_cast<std::size_t>(x)] > 0.3F);  // what stays
  }
}

TEST_CASE("light in a corner loses three quarters of what is spread widely, and nothing comes in from outside") {
  std::vector<float> plane = pointAt(300, 300, 0, 0);
  const std::vector<BlurredShare> shares{{20.0, 1.0}};
  spreadLight(plane, 300, 300, shares);
  CHECK(sumOf(plane) == doctest::Approx(0.25).epsilon(0.06));
}

TEST_CASE("Gaussians have their variance, at every level of the pyramid and wherever the pixel is") {
  for (const double sigma : {0.5, 1.5, 2.9, 3.1, 5.0, 6.1, 13.0, 25.0, 50.0}) {
    for (const int x : {256, 257, 258, 259}) {
      std::vector<float> plane = pointAt(512, 512, x, 255);
      const std::vector<BlurredShare> shares{{sigma, 1.0}};
      spreadLight(plane, 512, 512, shares);
      double sum = 0.0, mean = 0.0, square = 0.0;
      for (int v = 0; v < 512; ++v)
        for (int u = 0; u < 512; ++u) {
          const double light = plane[static_cast<std::size_t>(v) * 512 + static_cast<std::size_t>(u)];
          sum += light;
          mean += light * (u - x);
          square += light * (u - x) * (u - x);
        }
      CHECK_MESSAGE(square / sum == doctest::Approx(sigma * sigma + (sigma < 3.0 ? 1.0 / 12.0 : 0.0))
                                        .epsilon(sigma < 1.0 ? 0.03 : 0.01)
                                        .scale(0.0),
                    sigma);
      CHECK(std::abs(mean / sum) < 0.01 * sigma);
    }
  }
}

TEST_CASE("the veil of a small source is that of CIE 146 from 1 to 20 degrees") {
  // An eye of 30 years with brown irises at 10 degrees: 0.01 + (0.05 + 0.005) 1.0531 cd/m2 a lux.
  CHECK(glareVeil(radians(10.0)) == doctest::Approx(0.06792).epsilon(1e-3));
  const double pixel = radians(0.1);
  constexpr int kSide = 801, kMiddle = 400;
  Image image{kSide, kSide, {}};
  for (const char* name : {"R", "G", "B", "Variance.Y"}) image.add(name) = pointAt(kSide, kSide, kMiddle, kMiddle);
  addGlare(image, pixel);
  const std::vector<float>& green = *image.find("G");
  for (const double angle : {1.0, 2.0, 3.0, 5.0, 10.0, 15.0, 20.0}) {
    const auto away = static_cast<std::size_t>(std::lround(angle / 0.1));
    const double lux = pixel * pixel;
    for (const std::size_t i : {kMiddle * std::size_t{kSide} + kMiddle + away, (kMiddle - away) * kSide + kMiddle})
      CHECK_MESSAGE(green[i] / lux == doctest::Approx(glareVeil(radians(angle))).epsilon(0.06).scale(0.0), angle);
  }
  // Most light stays within a tenth of a degree, three quarters of it or so.
  double stays = green[kMiddle * std::size_t{kSide} + kMiddle];
  CHECK(stays > 0.65);
  CHECK(stays < 0.85);
  CHECK(*image.find("Variance.Y") == pointAt(kSide, kSide, kMiddle, kMiddle));
}

TEST_CASE("older and lighter eyes scatter more") {
  CHECK(glareVeil(radians(5.0), {70.0, 0.5}) > 1.8 * glareVeil(radians(5.0), {20.0, 0.5}));
  CHECK(glareVeil(radians(30.0), {30.0, 1.0}) > glareVeil(radians(30.0), {30.0, 0.0}));
  double young = 0.0, old = 0.0;
  for (const BlurredShare& part : glareOf({20.0, 0.5})) young += part.share;
  for (const BlurredShare& part : glareOf({80.0, 0.5})) old += part.share;
  CHECK(young > 0.2);
  CHECK(old > young);
  CHECK(old < 0.6);
}
