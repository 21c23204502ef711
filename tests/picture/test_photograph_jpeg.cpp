// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "picture/photograph.h"
#include "picture_files.h"
#include "temporary_directory.h"

namespace parhelion {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// Soft gradients, which all kinds of JPEG keep to within a few codes.
Bytes gradients(int width, int height, int channels) {
  Bytes samples;
  for (int i = 0; i < width * height; ++i) {
    for (int c = 0; c < channels; ++c) {
      samples.push_back(static_cast<std::uint8_t>(20 + i % width * (c + 1) / 2 + i / width));
    }
  }
  return samples;
}

int worstDifference(const Photograph& photograph, const Bytes& wanted) {
  const auto& samples = std::get<Bytes>(photograph.samples);
  if (samples.size() != wanted.size()) return 999;
  int worst = 0;
  for (std::size_t i = 0; i < wanted.size(); ++i) worst = std::max(worst, std::abs(samples[i] - wanted[i]));
  return worst;
}

std::string profileSegments(const std::string& profile, const std::vector<int>& order, int parts) {
  std::string segments;
  const std::size_t length = profile.size() / static_cast<std::size_t>(parts) + 1;
  for (const int number : order) {
    segments += jpegSegment(
        0xE2, std::string("ICC_PROFILE\0", 12) + static_cast<char>(number) + static_cast<char>(parts) +
                  profile.substr(std::min(static_cast<std::size_t>(number - 1) * length, profile.size()), length));
  }
  return segments;
}

}  // namespace

TEST_CASE("baseline and progressive JPEGs of every subsampling are read") {
  const TemporaryDirectory directory;
  const Bytes samples = gradients(61, 43, 3);
  for (const int subsampling : {TJSAMP_444, TJSAMP_422, TJSAMP_420, TJSAMP_440, TJSAMP_411}) {
    for (const int flags : {0, TJFLAG_PROGRESSIVE}) {
      CAPTURE(subsampling);
      put(directory / "in.jpg", jpegFile(samples, 61, 43, TJPF_RGB, subsampling, flags));
      const Photograph back = readPhotograph(directory / "in.jpg");
      CHECK(back.width == 61);
      CHECK(back.height == 43);
      CHECK(worstDifference(back, samples) <= 8);  // halved colours of a slope of 3/2 codes a pixel, and the quality
    }
  }
}

TEST_CASE("a grey JPEG becomes RGB") {
  const TemporaryDirectory directory;
  const Bytes grey = gradients(40, 30, 1);
  put(directory / "in.jpg", jpegFile(grey, 40, 30, TJPF_GRAY, TJSAMP_GRAY));
  Bytes wanted;
  for (const std::uint8_t v : grey) wanted.insert(wanted.end(), 3, v);
  const Photograph back = readPhotograph(directory / "in.jpg");
  CHECK(back.channels == 3);
  CHECK(worstDifference(back, wanted) <= 3);
}

TEST_CASE("the smallest JPEG is one pixel") {
  const TemporaryDirectory directory;
  put(directory / "in.jpg", jpegFile({10, 200, 30}, 1, 1));
  CHECK(worstDifference(readPhotograph(directory / "in.jpg"), {10, 200, 30}) <= 4);
}

TEST_CASE("flat JPEGs are the smallest there are, and are not taken for lies") {
  const TemporaryDirectory directory;
  const Bytes white(3 * 2048 * 1024, 255);
  for (const int subsampling : {TJSAMP_444, TJSAMP_420}) {
    for (const int flags : {0, TJFLAG_PROGRESSIVE}) {
      put(directory / "in.jpg", jpegFile(white, 2048, 1024, TJPF_RGB, subsampling, flags, 10));
      CHECK(worstDifference(readPhotograph(directory / "in.jpg"), white) == 0);
    }
  }
}

TEST_CASE("CMYK and other coding than Huffman's are refused by name") {
  const TemporaryDirectory directory;
  const auto path = directory / "in.jpg";
  put(path, jpegFile(gradients(16, 16, 4), 16, 16, TJPF_CMYK));
  CHECK(errorOf([&] { readPhotograph(path); }) == path.string() + ": its colours are CMYK; only grey and RGB are read");
  std::string jpeg = jpegFile(gradients(16, 16, 3), 16, 16);
  const std::size_t frame = jpeg.find(std::string("\xff\xc0\x00\x11\x08", 5));
  jpeg[frame + 1] = '\xc9';
  put(path, jpeg);
  CHECK(errorOf([&] { readPhotograph(path); }) == path.string() + ": JPEGs with arithmetic coding are not read");
  jpeg[frame + 1] = '\xc3';
  put(path, jpeg);
  CHECK(errorOf([&] { readPhotograph(path); }).find("Unsupported JPEG process") != std::string::npos);
  jpeg[frame + 1] = '\xc1';
  jpeg[frame + 4] = 12;
  put(path, jpeg);
  CHECK(errorOf([&] { readPhotograph(path); }).find("Unsupported JPEG data precision 12") != std::string::npos);
}

TEST_CASE("the profile of a JPEG decides, in however many parts and whatever order") {
  const TemporaryDirectory directory;
  const auto path = directory / "photo.jpg";
  const std::string jpeg = jpegFile(gradients(16, 16, 3), 16, 16);
  const std::string srgb = profileBytes(cmsCreate_sRGBProfile()), adobe = adobeRgbProfile();
  put(path, withSegments(jpeg, profileSegments(srgb, {1}, 1)));
  CHECK(readPhotograph(path).width == 16);
  put(path, withSegments(jpeg, profileSegments(srgb, {3, 1, 2}, 3)));
  CHECK(readPhotograph(path).width == 16);
  put(path, withSegments(jpeg, profileSegments(adobe, {2, 1}, 2)));
  CHECK(errorOf([&] { readPhotograph(path); }) ==
        path.string() +
            ": its colours are in the profile \"Adobe RGB (1998)\", not sRGB; convert it, or say "
            "--assume-srgb to take them as they are");
  CHECK(readPhotograph(path, {.assumeSrgb = true}).width == 16);

  for (const std::vector<int>& order : {std::vector{1}, {2}, {1, 1}, {1, 3}}) {
    put(path, withSegments(jpeg, profileSegments(srgb, order, 2)));
    CHECK(errorOf([&] { readPhotograph(path); }).find("its colours are in a damaged profile;") != std::string::npos);
    CHECK(readPhotograph(path, {.assumeSrgb = true}).width == 16);
  }
}

TEST_CASE("bytes that do not belong before a marker are passed over, but not where the file is cut as well") {
  const TemporaryDirectory directory;
  const auto path = directory / "in.jpg";
  const Bytes samples = gradients(32, 32, 3);
  const std::string jpeg = jpegFile(samples, 32, 32);
  const std::string atEnd = std::string(jpeg).insert(jpeg.size() - 2, 40, '\0');
  put(path, atEnd);
  CHECK(worstDifference(readPhotograph(path), samples) <= 8);
  const std::string inHeader = std::string(jpeg).insert(2 + 2 + 16, "abc");  // after the JFIF segment
  put(path, inHeader);
  CHECK(worstDifference(readPhotograph(path), samples) <= 8);
  put(path, inHeader.substr(0, inHeader.size() - 100));
  CHECK(errorOf([&] { readPhotograph(path); }).find("the JPEG is damaged or cut short: ") != std::string::npos);
}

TEST_CASE("what follows the end of a JPEG does not matter, nor an Exif block of rubbish") {
  const TemporaryDirectory directory;
  const auto path = directory / "in.jpg";
  const std::string jpeg = jpegFile(gradients(16, 16, 3), 16, 16);
  put(path, jpeg + jpeg + std::string(1000, 'x'));  // as telephones append a second picture
  CHECK(readPhotograph(path).width == 16);
  for (const std::string& exif : {std::string(), std::string("x"), std::string(60000, '\xff'), exifBlock(9)}) {
    put(path, withSegments(jpeg, jpegSegment(0xE1, std::string("Exif\0\0", 6) + exif)));
    CHECK(readPhotograph(path).exif.orientation == 1);
  }
}

}  // namespace parhelion
