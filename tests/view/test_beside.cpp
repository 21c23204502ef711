// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <limits>
#include <stdexcept>

#include "pictures.h"
#include "view/beside.h"
#include "view/colour_difference.h"

using namespace parhelion;
using namespace parhelion::test;

namespace {

Preview flat(int width, int height, std::uint8_t value) {
  return {width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(3 * width * height), value), 0};
}

int at(const Preview& picture, int x, int y) {
  return picture.rgb[static_cast<std::size_t>(3 * (y * picture.width + x))];
}

}  // namespace

TEST_CASE("side by side every pixel stays a pixel, and the lower picture stands in the middle on black") {
  const Preview sheet = beside(flat(10, 8, 200), flat(6, 4, 50));
  CHECK(sheet.width == 10 + 4 + 6);
  CHECK(sheet.height == 8);
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 20; ++x) {
      const int expected = x < 10 ? 200 : x < 14 ? 128 : y >= 2 && y < 6 ? 50 : 0;
      CHECK(at(sheet, x, y) == expected);
    }
}

TEST_CASE("the difference of a picture and itself is mid-grey") {
  const Image sky = light(20, 10, [](int c, int x, int y) { return 0.1 * c + 0.01 * x * y; });
  const LightDifference none = minus(sky, sky);
  CHECK(none.gain == 0.0);
  for (const std::uint8_t value : quantised(none.picture).rgb) CHECK(value == 128);
}

TEST_CASE("the difference is linear, has a sign, and its bulk fills the range") {
  const Image one = light(100, 10, [](int c, int x, int) { return c == 1 ? 0.5 + 0.001 * (x - 50) : 0.25; });
  const Image other = light(100, 10, [](int c, int, int) { return c == 1 ? 0.5 : 0.25; });
  const LightDifference given = minus(one, other, 3.0);
  for (int x = 0; x < 100; ++x) {
    CHECK(given.picture.planes[1][static_cast<std::size_t>(x)] ==
          doctest::Approx(kMidGrey + 0.003 * (x - 50)).epsilon(1e-5));
    CHECK(given.picture.planes[0][static_cast<std::size_t>(x)] == doctest::Approx(kMidGrey));
  }
  CHECK(minus(one, other).gain == doctest::Approx((1.0 - kMidGrey) / 0.05).epsilon(0.03));
}

TEST_CASE("what is not finite shows no difference, and sizes that differ are refused") {
  Image one = light(4, 4, [](int, int, int) { return 1.0; });
  const Image other = light(4, 4, [](int, int, int) { return 0.5; });
  one.channels[0].samples[3] = std::numeric_limits<float>::quiet_NaN();
  one.channels[1].samples[3] = std::numeric_limits<float>::infinity();
  const LightDifference difference = minus(one, other);
  CHECK(difference.picture.planes[0][3] == static_cast<float>(kMidGrey));
  CHECK(difference.picture.planes[1][3] == static_cast<float>(kMidGrey));
  CHECK(difference.picture.planes[2][3] == 1.0F);
  CHECK_THROWS_AS(minus(one, light(4, 5, [](int, int, int) { return 0.0; })), std::invalid_argument);
}
