// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "picture/photograph.h"
#include "picture_files.h"
#include "temporary_directory.h"

namespace parhelion {
namespace {

using Bytes = std::vector<std::uint8_t>;
using Words = std::vector<std::uint16_t>;

/// Reads a file of those bytes.
Photograph readBytes(const TemporaryDirectory& directory, const std::string& bytes, const PhotographRules& rules = {}) {
  put(directory / "in.png", bytes);
  return readPhotograph(directory / "in.png", rules);
}

std::string numbers(const std::vector<std::uint32_t>& all) {
  std::string text;
  for (const std::uint32_t number : all) text += bigEndian(number);
  return text;
}

const std::vector<std::uint32_t> kRec709{31270, 32900, 64000, 33000, 30000, 60000, 15000, 6000};
const std::vector<std::uint32_t> kRec2020{31270, 32900, 70800, 29200, 17000, 79700, 13100, 4600};

}  // namespace

TEST_CASE("grey PNGs of 1, 2, 4, 8 and 16 bits become RGB of the same grey") {
  const TemporaryDirectory directory;
  const std::string row("\xb4\x1b", 2);  // 1011 0100 0001 1011
  const auto firstReds = [&](int bits) {
    const auto width = static_cast<std::uint32_t>(bits == 16 ? 1 : 16 / bits);
    const Photograph back = readBytes(directory, pngFile({width, 1, bits, 0}, scanLines(row, 2)));
    CHECK(back.channels == 3);
    const auto& samples = std::get<Bytes>(back.samples);
    CHECK(samples[0] == samples[1]);
    CHECK(samples[0] == samples[2]);
    return std::vector<int>{samples[0], samples[3]};
  };
  CHECK(firstReds(1) == std::vector{255, 0});
  CHECK(firstReds(2) == std::vector{2 * 85, 3 * 85});
  CHECK(firstReds(4) == std::vector{11 * 17, 4 * 17});
  CHECK(firstReds(8) == std::vector{0xb4, 0x1b});
  const Photograph deep = readBytes(directory, pngFile({1, 1, 16, 0}, scanLines(row, 2)));
  CHECK(std::get<Words>(deep.samples) == Words(3, 0xb41b));
}

TEST_CASE("alpha of a PNG is the fourth channel, and grey with alpha becomes RGBA") {
  const TemporaryDirectory directory;
  const Photograph colour = readBytes(directory, pngFile({1, 1, 8, 6}, scanLines("\1\2\3\4", 4)));
  CHECK(colour.channels == 4);
  CHECK(std::get<Bytes>(colour.samples) == Bytes{1, 2, 3, 4});
  const Photograph grey = readBytes(directory, pngFile({1, 1, 8, 4}, scanLines("\7\x80", 2)));
  CHECK(std::get<Bytes>(grey.samples) == Bytes{7, 7, 7, 0x80});
  const Photograph deep = readBytes(directory, pngFile({1, 1, 16, 4}, scanLines("\1\2\3\4", 4)));
  CHECK(std::get<Words>(deep.samples) == Words{0x102, 0x102, 0x102, 0x304});
}

TEST_CASE("palettes and transparent colours of a PNG are resolved") {
  const TemporaryDirectory directory;
  const std::string palette = pngChunk("PLTE", "abcdef");
  const Photograph opaque = readBytes(directory, pngFile({2, 1, 1, 3}, scanLines("\x40", 1), palette));
  CHECK(opaque.channels == 3);
  CHECK(std::get<Bytes>(opaque.samples) == Bytes{'a', 'b', 'c', 'd', 'e', 'f'});
  const Photograph clear =
      readBytes(directory, pngFile({2, 1, 1, 3}, scanLines("\x40", 1), palette + pngChunk("tRNS", "\x7f")));
  CHECK(clear.channels == 4);
  CHECK(std::get<Bytes>(clear.samples) == Bytes{'a', 'b', 'c', 0x7f, 'd', 'e', 'f', 255});
  const std::string key = pngChunk("tRNS", std::string("\0\1\0\2\0\3", 6));
  const Photograph keyed = readBytes(directory, pngFile({2, 1}, scanLines("\1\2\3\1\2\4", 6), key));
  CHECK(std::get<Bytes>(keyed.samples) == Bytes{1, 2, 3, 0, 1, 2, 4, 255});
}

TEST_CASE("an interlaced PNG has the same pixels") {
  const TemporaryDirectory directory;
  const int width = 13, height = 11;
  const Bytes samples = noiseSamples<std::uint8_t>(3 * 13 * 11);
  std::string lines;
  const int passes[7][4] = {{0, 0, 8, 8}, {4, 0, 8, 8}, {0, 4, 4, 8}, {2, 0, 4, 4},
                            {0, 2, 2, 4}, {1, 0, 2, 2}, {0, 1, 1, 2}};
  for (const auto& [left, top, stepX, stepY] : passes) {  // PNG specification, 8.2
    for (int y = top; y < height; y += stepY) {
      lines.push_back('\0');
      for (int x = left; x < width; x += stepX) {
        lines += asText(samples).substr(static_cast<std::size_t>(3 * (y * width + x)), 3);
      }
    }
  }
  const Photograph back = readBytes(directory, pngFile({13, 11, 8, 2, true}, lines));
  CHECK(std::get<Bytes>(back.samples) == samples);
}

TEST_CASE("the profile of a PNG decides") {
  const TemporaryDirectory directory;
  const auto withProfile = [](const std::string& profile, int colourType = 2, const std::string& more = "") {
    const std::size_t bytes = colourType == 2 ? 3 : 1;
    return pngFile({1, 1, 8, colourType}, scanLines("abc", 3).substr(0, 1 + bytes),
                   more + pngChunk("iCCP", std::string("profile\0\0", 9) + deflated(profile)));
  };
  const std::string adobe = adobeRgbProfile();
  CHECK(readBytes(directory, withProfile(profileBytes(cmsCreate_sRGBProfile()))).width == 1);
  CHECK(errorOf([&] {
          readBytes(directory, withProfile(adobe));
        }).find("in the profile \"Adobe RGB (1998)\", not sRGB") != std::string::npos);
  CHECK(readBytes(directory, withProfile(adobe), {.assumeSrgb = true}).width == 1);
  cmsToneCurve* power = cmsBuildGamma(nullptr, 2.2);
  CHECK(readBytes(directory, withProfile(profileBytes(cmsCreateGrayProfile(cmsD50_xyY(), power)), 0)).width == 1);
  cmsFreeToneCurve(power);
  // It counts for more than gAMA.
  CHECK(readBytes(directory, withProfile(profileBytes(cmsCreate_sRGBProfile()), 2, pngChunk("gAMA", bigEndian(100000))))
            .width == 1);

  for (const std::string& damaged : {adobe.substr(0, 100), adobe.substr(0, adobe.size() - 9), std::string("none")}) {
    CHECK(errorOf([&] { readBytes(directory, withProfile(damaged)); }).find("in a damaged profile; convert it") !=
          std::string::npos);
    CHECK(readBytes(directory, withProfile(damaged), {.assumeSrgb = true}).width == 1);
  }
}

TEST_CASE("gamma and primaries of a PNG must be about those of sRGB") {
  const TemporaryDirectory directory;
  const auto reading = [&](const std::string& chunks, const PhotographRules& rules = {}) {
    return errorOf([&] { readBytes(directory, pngFile({1, 1}, scanLines("abc", 3), chunks), rules); });
  };
  const auto gamma = [](std::uint32_t times100000) { return pngChunk("gAMA", bigEndian(times100000)); };
  CHECK(reading(gamma(45455)).empty());
  CHECK(reading(gamma(45455) + pngChunk("cHRM", numbers(kRec709))).empty());
  CHECK(reading(gamma(100000)).find("its colours are linear (gamma 1), not sRGB; convert it") != std::string::npos);
  CHECK(reading(gamma(100000), {.assumeSrgb = true}).empty());
  CHECK(reading(gamma(55556)).find("its colours have gamma 1.8, not sRGB's") != std::string::npos);
  CHECK(reading(gamma(45455) + pngChunk("cHRM", numbers(kRec2020))).find("primaries red (0.708, 0.292)") !=
        std::string::npos);
  // The sRGB chunk counts for more.
  CHECK(reading(pngChunk("sRGB", std::string(1, '\0')) + gamma(100000)).empty());
}

TEST_CASE("text and Exif of a PNG are read, packed or not, before the picture or after it") {
  const TemporaryDirectory directory;
  const std::string before = pngChunk("tEXt", std::string("Software\0Parhelion", 18)) +
                             pngChunk("zTXt", std::string("Comment\0\0", 9) + deflated("a halo"));
  std::string png = pngFile({2, 1}, scanLines("abcdef", 6), before);
  png.insert(png.size() - 12, pngChunk("iTXt", std::string("Title\0\0\0\0\0sky", 13)) + pngChunk("eXIf", exifBlock(6)));
  const Photograph back = readBytes(directory, png);
  CHECK(back.text ==
        std::map<std::string, std::string>{{"Comment", "a halo"}, {"Software", "Parhelion"}, {"Title", "sky"}});
  CHECK(back.exif.orientation == 6);
  CHECK(back.width == 1);
  CHECK(back.height == 2);
}

}  // namespace parhelion
