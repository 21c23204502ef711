// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <png.h>

#include <random>

#include "picture/png.h"
#include "temporary_directory.h"

namespace parhelion {
namespace {

Preview noise(int width, int height) {
  Preview preview{width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(3 * width * height)), 0};
  std::mt19937 random(10);
  for (std::uint8_t& v : preview.rgb) v = static_cast<std::uint8_t>(random());
  return preview;
}

}  // namespace

TEST_CASE("a PNG decodes to the pixels it was written from") {
  const TemporaryDirectory directory;
  const auto path = directory / "out.png";
  const Preview preview = noise(37, 21);
  writePng(path, preview, {{"Exposure", "+3.5 stops"}, {"Software", "Parhelion"}});
  png_image reader{};
  reader.version = PNG_IMAGE_VERSION;
  REQUIRE(png_image_begin_read_from_file(&reader, path.c_str()));
  CHECK(reader.width == 37);
  CHECK(reader.height == 21);
  CHECK(reader.format == PNG_FORMAT_RGB);
  std::vector<std::uint8_t> pixels(PNG_IMAGE_SIZE(reader));
  REQUIRE(png_image_finish_read(&reader, nullptr, pixels.data(), 0, nullptr));
  CHECK(pixels == preview.rgb);
  const std::string bytes = contents(path);
  CHECK(bytes.find("sRGB") != std::string::npos);
  CHECK(bytes.find(std::string("tEXtExposure\0+3.5 stops", 23)) != std::string::npos);
}

TEST_CASE("a PNG that cannot be written is told with its path") {
  const TemporaryDirectory directory;
  const auto missing = directory / "none" / "out.png";
  CHECK(errorOf([&] { writePng(missing, noise(4, 4), {}); }) == noFolderFor(missing));
  for (const int size : {4, 300}) {
    CHECK(errorOf([&] { writePng("/dev/full", noise(size, size), {}); }) == "/dev/full: No space left on device");
  }
  // libpng refuses an empty picture; nothing is left behind.
  const std::string error = errorOf([&] { writePng(directory / "out.png", Preview{}, {}); });
  CHECK(error.find((directory / "out.png").string() + ": PNG: ") == 0);
  CHECK(directory.names().empty());
}

}  // namespace parhelion
