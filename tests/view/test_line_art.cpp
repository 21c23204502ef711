// SPDX-License-Identifier: Apache-2.0
#include "view/line_art.h"

#include <stdexcept>

#include <doctest/doctest.h>

#include "picture/photograph.h"
#include "picture/temporary_directory.h"

using namespace parhelion;

TEST_CASE("line art covers a picture in proportion to its alpha") {
  Preview picture{3, 1, {10, 20, 30, 10, 20, 30, 0, 100, 255}, 0};
  layOver(picture, {3, 1, {200, 100, 50, 255, 200, 100, 50, 0, 255, 0, 255, 51}});
  CHECK(picture.rgb == std::vector<std::uint8_t>{200, 100, 50, 10, 20, 30, 51, 80, 255});
}

TEST_CASE("line art of another size is refused") {
  Preview picture{2, 1, std::vector<std::uint8_t>(6), 0};
  CHECK_THROWS_AS(layOver(picture, {1, 2, std::vector<std::uint8_t>(8)}), std::invalid_argument);
}

TEST_CASE("line art is written with its alpha and its text") {
  const TemporaryDirectory directory;
  const LineArt lines{2, 1, {1, 2, 3, 4, 250, 251, 252, 253}};
  writeLineArt(directory / "lines.png", lines, {{"Software", "parhelion"}});
  const Photograph read = readPhotograph(directory / "lines.png");
  CHECK(read.width == 2);
  CHECK(read.height == 1);
  REQUIRE(read.channels == 4);
  REQUIRE(std::holds_alternative<std::vector<std::uint8_t>>(read.samples));
  CHECK(std::get<std::vector<std::uint8_t>>(read.samples) == lines.rgba);
  CHECK(read.text.at("Software") == "parhelion");
}
