// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <stdexcept>

#include "pictures.h"
#include "view/colour_difference.h"

using namespace parhelion;
using namespace parhelion::test;

namespace {

constexpr std::uint8_t kMidStep = 128;

}  // namespace

TEST_CASE("red minus blue of a grey picture is mid-grey everywhere, whatever the gain") {
  const Display grey = display(40, 30, [](int, int x, int y) { return ((7 * x + 13 * y) % 256) / 255.0; });
  for (const std::optional<double> gain : {std::optional<double>{}, std::optional(1.0), std::optional(1000.0)}) {
    const Preview preview = quantised(redMinusBlue(grey, gain).picture);
    for (const std::uint8_t value : preview.rgb) CHECK(value == kMidStep);
  }
}

TEST_CASE("redder is lighter by the gain, and the median is mid-grey") {
  // Three fifths of the picture are neutral, a fifth is redder by 0.1 and a fifth bluer by 0.05.
  const Display picture = display(50, 10, [](int c, int x, int) {
    return 0.5 + (c == 0 && x < 10 ? 0.1 : 0.0) + (c == 2 && x >= 40 ? 0.05 : 0.0);
  });
  const ColourDifference given = redMinusBlue(picture, 2.0);
  CHECK(given.centre == 0.0);
  CHECK(given.picture.planes[0][0] == doctest::Approx(kMidGrey + 0.2).epsilon(1e-6));
  CHECK(given.picture.planes[1][20] == doctest::Approx(kMidGrey));
  CHECK(given.picture.planes[2][49] == doctest::Approx(kMidGrey - 0.1).epsilon(1e-6));

  const ColourDifference automatic = redMinusBlue(picture);
  CHECK(automatic.gain == doctest::Approx((1.0 - kMidGrey) / 0.1).epsilon(1e-6));
  CHECK(automatic.picture.planes[0][0] == doctest::Approx(1.0));
}

TEST_CASE("a few odd pixels do not change the stretch, nor does what is not sky or is black") {
  const auto sky = [](int c, int x, int) { return 0.4 + (c == 0 ? 0.001 * x : 0.0); };
  const double gain = redMinusBlue(display(100, 100, sky)).gain;
  const Display odd = display(100, 100, [&](int c, int x, int y) { return y == 0 && x < 5 ? (c == 0) : sky(c, x, y); });
  CHECK(redMinusBlue(odd).gain == doctest::Approx(gain).epsilon(0.05));

  const Display landscape = display(100, 200, [&](int c, int x, int y) { return y < 100 ? sky(c, x, y) : (c == 2); });
  std::vector<std::uint8_t> mask(100 * 200, 255);
  std::fill(mask.begin() + 100 * 100, mask.end(), std::uint8_t{100});
  CHECK(redMinusBlue(landscape, std::nullopt, mask).gain == doctest::Approx(gain));
  CHECK(redMinusBlue(landscape).gain < 0.5 * gain);

  const Display frame = display(100, 200, [&](int c, int x, int y) { return y < 100 ? sky(c, x, y) : 0.0; });
  CHECK(redMinusBlue(frame).gain == doctest::Approx(gain));
  CHECK_THROWS_AS(redMinusBlue(landscape, 1.0, std::vector<std::uint8_t>(7)), std::invalid_argument);
  CHECK_THROWS_AS(redMinusBlue(landscape, 1.0, std::vector<std::uint8_t>(100 * 200, 127)), std::invalid_argument);
}

TEST_CASE("red minus blue of a black picture is mid-grey") {
  const ColourDifference black = redMinusBlue(display(3, 3, [](int, int, int) { return 0.0; }));
  CHECK(black.gain == 0.0);
  CHECK(quantised(black.picture).rgb == std::vector<std::uint8_t>(27, kMidStep));
}
