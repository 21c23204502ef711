// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <stdexcept>

#include "photo/sky_mask.h"
#include "picture/temporary_directory.h"

namespace parhelion {

TEST_CASE("a mask comes back from its PNG as it was") {
  SkyMask mask{16, 16, std::vector<std::uint8_t>(256)};
  for (std::size_t i = 0; i < mask.sky.size(); ++i) mask.sky[i] = static_cast<std::uint8_t>(i);
  const TemporaryDirectory directory;
  const auto path = directory / "mask.png";
  writeSkyMask(path, mask, {{"Title", "sky"}});
  CHECK(readSkyMask(path) == mask);
}

TEST_CASE("a mask may have 16 bits, floats or alpha") {
  Photograph picture;
  picture.width = 2;
  picture.height = 1;
  picture.samples = std::vector<std::uint16_t>{65535, 65535, 65535, 32896, 32896, 32896};
  CHECK(skyMaskOf(picture).sky == std::vector<std::uint8_t>{255, 128});
  picture.samples = std::vector<float>{2.0F, 2.0F, 2.0F, 0.5F, 0.5F, 0.5F};
  CHECK(skyMaskOf(picture).sky == std::vector<std::uint8_t>{255, 128});
  picture.channels = 4;
  picture.samples = std::vector<std::uint8_t>{255, 255, 255, 0, 10, 20, 30, 255};
  CHECK(skyMaskOf(picture).sky == std::vector<std::uint8_t>{255, 20});
}

TEST_CASE("a mask that is not there is an error that names it") {
  CHECK_THROWS_WITH_AS(readSkyMask("no_such_mask.png"), doctest::Contains("no_such_mask.png"), std::runtime_error);
}

}  // namespace parhelion
