// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "picture/exr.h"
#include "picture/photograph.h"
#include "picture/transfer.h"
#include "picture/upright.h"
#include "picture_files.h"
#include "temporary_directory.h"

namespace parhelion {
namespace {

template <typename Sample>
Photograph photographOf(int width, int height, int channels, std::vector<Sample> samples) {
  return {width, height, channels, std::move(samples), {}, {}};
}

std::vector<float> normalFloats(std::size_t count) {
  std::vector<float> samples(count);
  std::mt19937 random(5);
  std::normal_distribution<float> normal;
  for (float& s : samples) s = normal(random);
  return samples;
}

/// Where the pixel of stored row r and column c belongs, from the words of CIPA DC-008 on the tag: where the 0th row
/// and the 0th column are to be seen. `width` and `height` are those of the upright picture.
std::pair<int, int> place(int orientation, int r, int c, int width, int height) {
  const int fromRight = width - 1, fromBottom = height - 1;
  switch (orientation) {
    case 2:
      return {fromRight - c, r};  // row at the top, column at the right
    case 3:
      return {fromRight - c, fromBottom - r};  // bottom, right
    case 4:
      return {c, fromBottom - r};  // bottom, left
    case 5:
      return {r, c};  // left, top
    case 6:
      return {fromRight - r, c};  // right, top
    case 7:
      return {fromRight - r, fromBottom - c};  // right, bottom
    case 8:
      return {r, fromBottom - c};  // left, bottom
    default:
      return {c, r};  // top, left
  }
}

}  // namespace

TEST_CASE("a photograph of 8 or 16 bits comes back from a PNG with the same bits") {
  const TemporaryDirectory directory;
  const auto path = directory / "out.png";
  for (const int channels : {3, 4}) {
    const auto count = static_cast<std::size_t>(37 * 21 * channels);
    const auto shallow = photographOf(37, 21, channels, noiseSamples<std::uint8_t>(count));
    const auto deep = photographOf(37, 21, channels, noiseSamples<std::uint16_t>(count));
    for (const Photograph& original : {shallow, deep}) {
      writePhotograph(path, original, {{"Software", "Parhelion"}, {"Comment", "halo"}});
      const Photograph back = readPhotograph(path);
      CHECK(back.width == 37);
      CHECK(back.height == 21);
      CHECK(back.channels == channels);
      CHECK((back.samples == original.samples));
      CHECK(back.text == std::map<std::string, std::string>{{"Comment", "halo"}, {"Software", "Parhelion"}});
    }
  }
}

TEST_CASE("linear floats come back from an EXR with the same bits") {
  const TemporaryDirectory directory;
  const auto path = directory / "out.EXR";
  for (const int channels : {3, 4}) {
    std::vector<float> samples = normalFloats(static_cast<std::size_t>(23 * 18 * channels));
    samples[7] = std::numeric_limits<float>::infinity();
    samples[8] = 1e30F;
    const auto original = photographOf(23, 18, channels, samples);
    writePhotograph(path, original, {{"software", "Parhelion"}});
    const Photograph back = readPhotograph(path);
    CHECK(back.channels == channels);
    CHECK((back.samples == original.samples));
    CHECK(back.text.at("software") == "Parhelion");
  }
}

TEST_CASE("codes written to an EXR are their linear light, and go back to the same codes in a PNG") {
  const TemporaryDirectory directory;
  const auto original = photographOf(64, 32, 4, noiseSamples<std::uint16_t>(64 * 32 * 4));
  writePhotograph(directory / "linear.exr", original, {});
  const Photograph linear = readPhotograph(directory / "linear.exr");
  const auto& codes = std::get<std::vector<std::uint16_t>>(original.samples);
  const auto& floats = std::get<std::vector<float>>(linear.samples);
  CHECK(floats[0] == srgbDecode16()[codes[0]]);
  CHECK(floats[3] == static_cast<float>(codes[3]) / 65535.0F);
  writePhotograph(directory / "again.png", linear, {});
  CHECK((readPhotograph(directory / "again.png").samples == original.samples));
}

TEST_CASE("floats in a PNG are clipped to black and white, and black where they are no numbers") {
  const TemporaryDirectory directory;
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const std::vector<float> samples{-1.0F, 0.0F, 0.5F, 2.0F, 1.0F, 7.0F, std::nanf(""), kInfinity, -kInfinity};
  writePhotograph(directory / "out.png", photographOf(3, 1, 3, samples), {});
  const std::vector<std::uint16_t> wanted{0, 0, toSrgb16(0.5F), 65535, 65535, 65535, 0, 0, 0};
  CHECK(std::get<std::vector<std::uint16_t>>(readPhotograph(directory / "out.png").samples) == wanted);
}

TEST_CASE("a photograph written as JPEG comes back within the loss of its coding") {
  const TemporaryDirectory directory;
  std::vector<std::uint8_t> samples;
  for (int y = 0; y < 48; ++y) {
    for (int x = 0; x < 64; ++x) {
      for (const int v : {x * 3, y * 4, 200 - x - y}) samples.push_back(static_cast<std::uint8_t>(v));
    }
  }
  std::vector<float> linear;
  std::vector<std::uint16_t> deep;
  for (const std::uint8_t code : samples) {
    const int away = static_cast<int>(deep.size() % 257) - 128;  // up to half a step of 8 bits
    deep.push_back(static_cast<std::uint16_t>(std::clamp(257 * code + away, 0, 65535)));
    linear.push_back(srgbDecode8()[code]);
  }
  writePhotograph(directory / "bytes.jpg", photographOf(64, 48, 3, samples), {{"Software", "Parhelion 1"}});
  writePhotograph(directory / "words.jpeg", photographOf(64, 48, 3, deep), {{"Software", "Parhelion 1"}});
  writePhotograph(directory / "floats.JPG", photographOf(64, 48, 3, linear), {{"Software", "Parhelion 1"}});
  const std::string file = contents(directory / "bytes.jpg");
  CHECK(contents(directory / "words.jpeg") == file);
  CHECK(contents(directory / "floats.JPG") == file);
  CHECK(file.find("\xff\xfe" + bigEndian(2 + 11, 2) + "Parhelion 1") != std::string::npos);
  CHECK(file.find(std::string("ICC_PROFILE\0\1\1", 14)) != std::string::npos);
  const std::size_t frame = file.find(std::string("\xff\xc0\x00\x11\x08", 5));
  REQUIRE(frame != std::string::npos);
  CHECK(file[frame + 11] == 0x11);  // luminance is sampled as finely as the colours are

  const auto back = std::get<std::vector<std::uint8_t>>(readPhotograph(directory / "bytes.jpg").samples);
  REQUIRE(back.size() == samples.size());
  int worst = 0;
  for (std::size_t i = 0; i < back.size(); ++i) worst = std::max(worst, std::abs(back[i] - samples[i]));
  CHECK(worst <= 8);  // at quality 95 the finest luminance step is 2 and the coarsest 12, colours' 10
}

TEST_CASE("alpha is left out of a JPEG") {
  const TemporaryDirectory directory;
  std::vector<std::uint8_t> rgba, rgb;
  for (int i = 0; i < 256; ++i) {
    for (const int v : {100, 150, 200, i}) rgba.push_back(static_cast<std::uint8_t>(v));
    for (const int v : {100, 150, 200}) rgb.push_back(static_cast<std::uint8_t>(v));
  }
  writePhotograph(directory / "rgba.jpg", photographOf(16, 16, 4, rgba), {});
  writePhotograph(directory / "rgb.jpg", photographOf(16, 16, 3, rgb), {});
  CHECK(contents(directory / "rgba.jpg") == contents(directory / "rgb.jpg"));
}

TEST_CASE("a picture cannot be written under another extension, nor where there is no directory") {
  const TemporaryDirectory directory;
  const auto picture = photographOf(2, 2, 3, noiseSamples<std::uint8_t>(12));
  CHECK(errorOf([&] { writePhotograph(directory / "out.tif", picture, {}); }) ==
        (directory / "out.tif").string() + ": a picture is written as .png, .jpg, .jpeg or .exr");
  for (const char* name : {"out.png", "out.jpg", "out.exr"}) {
    const auto missing = directory / "none" / name;
    CHECK(errorOf([&] { writePhotograph(missing, picture, {}); }) == noFolderFor(missing));
  }
  CHECK(directory.names().empty());
}

TEST_CASE("all eight orientations turn samples upright") {
  for (const int channels : {3, 4}) {
    for (int orientation = 1; orientation <= 8; ++orientation) {
      CAPTURE(orientation);
      const int storedWidth = 45, storedHeight = 70;  // more than one square of the copy, and no multiple
      const auto stored = noiseSamples<std::uint16_t>(static_cast<std::size_t>(45 * 70 * channels));
      auto photograph = photographOf(storedWidth, storedHeight, channels, stored);
      turnUpright(photograph, orientation);
      CHECK(photograph.width == (orientation < 5 ? 45 : 70));
      CHECK(photograph.height == (orientation < 5 ? 70 : 45));
      const auto& upright = std::get<std::vector<std::uint16_t>>(photograph.samples);
      REQUIRE(upright.size() == stored.size());
      int wrong = 0;
      for (int i = 0; i < 45 * 70 * channels; ++i) {
        const int pixel = i / channels;
        const auto [x, y] =
            place(orientation, pixel / storedWidth, pixel % storedWidth, photograph.width, photograph.height);
        const int at = (y * photograph.width + x) * channels + i % channels;
        wrong += upright[static_cast<std::size_t>(at)] != stored[static_cast<std::size_t>(i)];
      }
      CHECK(wrong == 0);
    }
  }
}

TEST_CASE("a JPEG and a PNG are turned by their Exif orientation") {
  const TemporaryDirectory directory;
  // The stored picture: 3 x 2 flat blocks of 8 x 8 pixels, which JPEG keeps.
  std::vector<std::uint8_t> stored;
  for (int i = 0; i < 24 * 16; ++i) {
    const int block = i % 24 / 8 + 3 * (i / 24 / 8);
    for (const int v : {40 * block, 255 - 30 * block, 20 * block + 90}) stored.push_back(static_cast<std::uint8_t>(v));
  }
  for (int orientation = 1; orientation <= 8; ++orientation) {
    CAPTURE(orientation);
    const std::string exif = exifBlock(orientation);
    put(directory / "in.jpg", withSegments(jpegFile(stored, 24, 16, TJPF_RGB, TJSAMP_444, 0, 100),
                                           jpegSegment(0xE1, std::string("Exif\0\0", 6) + exif)));
    put(directory / "in.png", pngFile({24, 16}, scanLines(asText(stored), 72), pngChunk("eXIf", exif)));
    for (const char* name : {"in.jpg", "in.png"}) {
      const Photograph back = readPhotograph(directory / name);
      REQUIRE(back.width == (orientation < 5 ? 24 : 16));
      CHECK(back.exif.orientation == orientation);
      const auto& upright = std::get<std::vector<std::uint8_t>>(back.samples);
      int worst = 0;
      for (int i = 0; i < 24 * 16; ++i) {
        const auto [x, y] = place(orientation, i / 24, i % 24, back.width, back.height);
        const auto at = static_cast<std::size_t>(3 * (y * back.width + x));
        for (std::size_t c = 0; c < 3; ++c) {
          worst = std::max(worst, std::abs(upright[at + c] - stored[3 * static_cast<std::size_t>(i) + c]));
        }
      }
      CHECK(worst <= (name == std::string("in.png") ? 0 : 3));  // rounding of YCbCr and of the DC at quality 100
    }
  }
}

TEST_CASE("linear light is averaged over squares, smaller ones at the right and at the bottom") {
  const auto codes = noiseSamples<std::uint8_t>(7 * 5 * 4);
  const Image image = linearImage(photographOf(7, 5, 4, codes), 3);
  CHECK(image.width == 3);
  CHECK(image.height == 2);
  const auto planes = image.rgb();
  for (int row = 0; row < 2; ++row) {
    for (int column = 0; column < 3; ++column) {
      for (std::size_t c = 0; c < 3; ++c) {
        double sum = 0.0;
        int count = 0;
        for (int y = 3 * row; y < std::min(3 * row + 3, 5); ++y) {
          for (int x = 3 * column; x < std::min(3 * column + 3, 7); ++x, ++count) {
            sum += srgbDecode(codes[static_cast<std::size_t>(4 * (7 * y + x)) + c] / 255.0);
          }
        }
        const float got = (*planes[c])[static_cast<std::size_t>(3 * row + column)];
        CHECK(got == doctest::Approx(sum / count).epsilon(2e-7));  // of floats
      }
    }
  }
}

TEST_CASE("linear light without reduction is each sample's own") {
  const auto words = noiseSamples<std::uint16_t>(5 * 4 * 3);
  const Image image = linearImage(photographOf(5, 4, 3, words));
  for (std::size_t i = 0; i < 20; ++i) {
    for (std::size_t c = 0; c < 3; ++c) CHECK((*image.rgb()[c])[i] == srgbDecode16()[words[3 * i + c]]);
  }
  const std::vector<float> floats{-0.5F, 2.0F, std::nanf(""), std::numeric_limits<float>::infinity(), 0.0F, 1e-20F};
  const Image exact = linearImage(photographOf(2, 1, 3, floats));
  CHECK(*exact.find("R") == std::vector<float>{-0.5F, 0.0F});
  CHECK(*exact.find("G") == std::vector<float>{2.0F, 0.0F});
  CHECK(*exact.find("B") == std::vector<float>{0.0F, 1e-20F});
}

}  // namespace parhelion
