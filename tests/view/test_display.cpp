// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>
#include <stdexcept>

#include "pictures.h"
#include "view/line_art.h"

using namespace parhelion;
using namespace parhelion::test;

TEST_CASE("a photograph of 8 bits goes to a display and back unchanged") {
  const Photograph photograph = noise(61, 37, 1);
  CHECK(quantised(shown(photograph)).rgb == std::get<std::vector<std::uint8_t>>(photograph.samples));
}

TEST_CASE("a photograph of 16 bits comes out within a step, black and white as they are") {
  Photograph photograph;
  photograph.width = 256;
  photograph.height = 1;
  std::vector<std::uint16_t> samples;
  for (int x = 0; x < 256; ++x)
    for (int c = 0; c < 3; ++c) samples.push_back(static_cast<std::uint16_t>(257 * x));
  photograph.samples = samples;
  const Preview preview = quantised(shown(photograph));
  for (int x = 0; x < 256; ++x) CHECK(preview.rgb[static_cast<std::size_t>(3 * x)] == x);
}

TEST_CASE("what is transparent is black on a display") {
  Photograph photograph;
  photograph.width = photograph.height = 1;
  photograph.channels = 4;
  photograph.samples = std::vector<std::uint8_t>{200, 100, 50, 51};
  const Preview preview = quantised(shown(photograph));
  CHECK(preview.rgb == std::vector<std::uint8_t>{40, 20, 10});
}

TEST_CASE("linear light on a display is the preview that render writes") {
  const Image image = light(64, 48, [](int c, int x, int y) { return 1e-4 * (x + 1) * (y + 2) * (c + 1) - 0.01; });
  for (const double stops : {-3.0, 0.0, 2.5})
    CHECK(quantised(developed(image, {stops})).rgb == developPreview(image, {stops}).rgb);
}

TEST_CASE("16 bits hold the display as it is, and lines over it are those over 8 bits") {
  const Image image = light(64, 48, [](int c, int x, int y) { return 1e-4 * (x + 1) * (y + 2) * (c + 1) - 0.01; });
  Display display = developed(image, {0.0, ToneCurve::filmic});
  CHECK(quantised(display).rgb == developPreview(image, {0.0, ToneCurve::filmic}).rgb);
  CHECK(quantised(display).rgb != developPreview(image, {0.0}).rgb);
  LineArt lines{64, 48, std::vector<std::uint8_t>(std::size_t{4} * 64 * 48)};
  for (std::size_t i = 0; i < lines.rgba.size(); ++i) lines.rgba[i] = static_cast<std::uint8_t>(37 * i);
  Preview coarse = quantised(display);
  const std::vector<std::uint16_t> before = quantised16(display);
  for (std::size_t i = 0; i < before.size(); ++i)
    CHECK(std::abs(before[i] / 65535.0 - display.planes[i % 3][i / 3]) <= 0.5001 / 65535.0);
  layOver(display, lines);
  layOver(coarse, lines);
  const std::vector<std::uint16_t> fine = quantised16(display);
  for (std::size_t i = 0; i < fine.size(); ++i) CHECK(std::abs(fine[i] / 257.0 - coarse.rgb[i]) <= 1.51);
  lines.height = 47;
  CHECK_THROWS_AS(layOver(display, lines), std::invalid_argument);
}

TEST_CASE("linear light is not shown without being developed") {
  Photograph photograph;
  photograph.width = photograph.height = 1;
  photograph.samples = std::vector<float>(3);
  CHECK_THROWS_AS(shown(photograph), std::invalid_argument);
}
