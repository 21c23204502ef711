// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <stdexcept>

#include "view/dots.h"

using namespace parhelion;

namespace {

Tally emptyTally(int width, int height) {
  TallyInfo info;
  info.camera.width = width;
  info.camera.height = height;
  return Tally(info, 1);
}

long blackPixels(const Preview& page) {
  long black = 0;
  for (std::size_t i = 0; i < page.rgb.size(); i += 3) {
    CHECK((page.rgb[i] == 0 || page.rgb[i] == 255));
    black += page.rgb[i] == 0 && page.rgb[i + 1] == 0 && page.rgb[i + 2] == 0;
  }
  return black;
}

}  // namespace

TEST_CASE("there are as many black dots as the tally has pixels that were hit, and in the same places") {
  Tally tally = emptyTally(64, 48);
  std::mt19937 random(3);
  for (int ray = 0; ray < 700; ++ray)
    tally.add(static_cast<int>(random() % 3072U), {0.0, 1e-3 * (ray % 5), 0.0}, ray % 2 == 0);
  const Preview page = dots(tally);
  long hit = 0;
  for (int pixel = 0; pixel < tally.pixels(); ++pixel) {
    hit += tally.hits(pixel) > 0;
    CHECK((page.rgb[static_cast<std::size_t>(3 * pixel)] == 0) == (tally.hits(pixel) > 0));
  }
  CHECK(hit > 500);
  CHECK(blackPixels(page) == hit);
}

TEST_CASE("dots are round and about their pixel, and end at the border") {
  for (const auto& [size, area] : {std::pair{1, 1}, {2, 4}, {3, 9}, {4, 12}, {5, 21}}) {
    Tally tally = emptyTally(16, 16);
    tally.add(16 * 8 + 8, {0.0, 1.0, 0.0}, true);
    const Preview page = dots(tally, size);
    CHECK(blackPixels(page) == area);
    CHECK(page.rgb[3 * (16 * 8 + 8)] == 0);
  }
  Tally corner = emptyTally(16, 16);
  corner.add(0, {0.0, 1.0, 0.0}, true);
  CHECK(blackPixels(dots(corner, 3)) == 4);
}

TEST_CASE("dots of another ink are where the black ones are") {
  Tally tally = emptyTally(16, 16);
  tally.add(16 * 8 + 8, {0.0, 1.0, 0.0}, true);
  Preview black = dots(tally, 3);
  for (std::uint8_t& value : black.rgb) value = value == 0 ? 153 : value;
  CHECK(dots(tally, 3, 153).rgb == black.rgb);
}

TEST_CASE("a dot of no size is refused") {
  const Tally tally = emptyTally(4, 4);
  CHECK_THROWS_AS(dots(tally, 0), std::invalid_argument);
  CHECK_THROWS_AS(dots(tally, kMaxDotSize + 1), std::invalid_argument);
}

TEST_CASE("dots grow with pictures that are looked at as a whole") {
  CHECK(usualDotSize(emptyTally(64, 48)) == 1);
  CHECK(usualDotSize(emptyTally(1599, 3000)) == 1);
  CHECK(usualDotSize(emptyTally(2400, 2400)) == 3);
}
