// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "jpeg_kinds.h"
#include "picture/jpeg_patch.h"
#include "picture/upright.h"
#include "temporary_directory.h"

namespace parhelion {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// Waves and noise between 60 and 150, so that light can be added without clipping.
Bytes texture(int width, int height, int channels = 3) {
  std::mt19937 random(3);
  std::uniform_int_distribution<int> noise(-10, 10);
  Bytes samples;
  for (int i = 0; i < width * height; ++i) {
    const double x = i % width, y = i / width;
    for (int c = 0; c < channels; ++c) {
      samples.push_back(
          static_cast<std::uint8_t>(105 + 35 * std::sin(0.21 * x + c) * std::cos(0.13 * y) + noise(random)));
    }
  }
  return samples;
}

struct Rectangle {
  int left, top, right, bottom;  // pixels as stored, the last two excluded
};

Bytes& bytesOf(Photograph& photograph) { return std::get<Bytes>(photograph.samples); }

/// Adds a colour and a grey slope to what is in the rectangle. Its chroma is constant there, so that neither the means
/// nor the interpolation of subsampled chroma change it.
void brighten(Photograph& stored, const Rectangle& r, const std::array<int, 3>& colour) {
  for (int y = r.top; y < r.bottom; ++y) {
    for (int x = r.left; x < r.right; ++x) {
      for (int c = 0; c < 3; ++c) {
        auto& sample = bytesOf(stored)[static_cast<std::size_t>(3 * (y * stored.width + x) + c)];
        sample = static_cast<std::uint8_t>(sample + colour[static_cast<std::size_t>(c)] + (x - r.left) / 2 +
                                           (y - r.top) / 3);
      }
    }
  }
}

/// An upright picture as it is stored under an orientation, and back.
Photograph asStored(Photograph upright, int orientation) {
  turnUpright(upright, orientation == 6 ? 8 : orientation == 8 ? 6 : orientation);
  return upright;
}

/// The rectangle grown to whole MCUs, or shrunk to those that lie in it.
Rectangle inUnits(const Rectangle& r, const JpegKind& kind, bool grown) {
  const int w = 8 * kind.across, h = 8 * kind.down;
  const auto low = [&](int at, int unit) { return (at + (grown ? 0 : unit - 1)) / unit * unit; };
  const auto high = [&](int at, int unit) { return (at + (grown ? unit - 1 : 0)) / unit * unit; };
  return {low(r.left, w), low(r.top, h), high(r.right, w), high(r.bottom, h)};
}

/// Samples that differ outside of a rectangle grown by `margin` pixels.
int differences(Photograph& a, Photograph& b, const Rectangle& r, int margin) {
  int count = 0;
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) {
      if (x >= r.left - margin && x < r.right + margin && y >= r.top - margin && y < r.bottom + margin) continue;
      for (int c = 0; c < 3; ++c) {
        const auto i = static_cast<std::size_t>(3 * (y * a.width + x) + c);
        count += bytesOf(a)[i] != bytesOf(b)[i];
      }
    }
  }
  return count;
}

double rmsDifference(Photograph& a, Photograph& b, const Rectangle& r) {
  double sum = 0.0;
  for (int y = r.top; y < r.bottom; ++y) {
    for (int x = 3 * r.left; x < 3 * r.right; ++x) {
      const auto i = static_cast<std::size_t>(3 * y * a.width + x);
      sum += std::pow(bytesOf(a)[i] - bytesOf(b)[i], 2);
    }
  }
  return std::sqrt(sum / (3.0 * (r.right - r.left) * (r.bottom - r.top)));
}

/// The rms error that rounding leaves in a sample where all coefficients changed. Rounding to steps has the variance
/// step^2 / 12 in each component's samples, as the transform is orthonormal; that of decoded samples has 1/12, before
/// the change and after; B, with the most of it, is Y + 1.772 Cb; and it is rounded to codes twice.
double mostRms(int step) {
  const double component = (step * step + 2.0) / 12.0;
  return std::sqrt(component * (1.0 + 1.772 * 1.772) + 2.0 / 12.0);
}

/// APPn and COM segments, one after the other, as they lie in the file before its picture.
std::string markersOf(const std::string& jpeg) {
  std::string all;
  for (std::size_t at = 2; at + 4 < jpeg.size();) {
    const auto byte = [&](std::size_t i) { return static_cast<std::size_t>(static_cast<unsigned char>(jpeg[i])); };
    const std::size_t marker = byte(at + 1), length = 2 + (byte(at + 2) << 8 | byte(at + 3));
    if (marker == 0xDA) break;
    if (marker == 0xFE || (marker >= 0xE0 && marker <= 0xEF)) all += jpeg.substr(at, length);
    at += length;
  }
  return all;
}

}  // namespace

TEST_CASE("in a patched JPEG only the blocks that changed decode to something else, and they to what was asked for") {
  const TemporaryDirectory directory;
  const auto in = directory / "in.jpg", out = directory / "out.jpg";
  constexpr int kWidth = 203, kHeight = 141;  // no multiples of any block
  // At the right border, in the midst, at the bottom.
  for (const Rectangle& r : {Rectangle{130, 20, 203, 75}, {37, 21, 138, 90}, {70, 67, 155, 141}}) {
    for (const JpegKind& kind : jpegKinds()) {
      CAPTURE(nameOf(kind));
      put(in, jpegOf(texture(kWidth, kHeight), kWidth, kHeight, kind));
      Photograph original = asStored(readPhotograph(in), kind.orientation);
      Photograph changed = original;
      REQUIRE(original.width == kWidth);
      brighten(changed, r, {32, 15, 5});
      Photograph upright = changed;
      turnUpright(upright, kind.orientation);
      REQUIRE(writePatchedJpeg(out, in, upright));

      Photograph back = asStored(readPhotograph(out), kind.orientation);
      CHECK(back.exif.orientation == kind.orientation);
      const int margin = kind.across * kind.down > 1 ? 1 : 0;  // interpolation of chroma
      CHECK(differences(back, original, inUnits(r, kind, true), margin) == 0);
      CHECK(rmsDifference(back, changed, inUnits(r, kind, false)) < mostRms(kStep));
    }
  }
}

TEST_CASE("a JPEG patched with itself decodes to the same bits") {
  const TemporaryDirectory directory;
  const auto in = directory / "in.jpg", out = directory / "out.jpg";
  for (const JpegKind& kind : jpegKinds()) {
    for (const auto& [width, height] : {std::pair{93, 71}, {1, 1}, {17, 3}, {64, 64}}) {
      CAPTURE(nameOf(kind));
      CAPTURE(width);
      put(in, jpegOf(noiseSamples<std::uint8_t>(static_cast<std::size_t>(3 * width * height)), width, height, kind));
      const Photograph original = readPhotograph(in);
      REQUIRE(writePatchedJpeg(out, in, original));
      CHECK((readPhotograph(out).samples == original.samples));
    }
  }
}

TEST_CASE("a patched JPEG keeps its markers, and is baseline or progressive as it was") {
  const TemporaryDirectory directory;
  const auto in = directory / "in.jpg", out = directory / "out.jpg";
  const std::string profile = profileBytes(cmsCreate_sRGBProfile());
  const std::string segments = jpegSegment(0xE2, std::string("ICC_PROFILE\0\1\1", 14) + profile) +
                               jpegSegment(0xFE, "first comment") + jpegSegment(0xED, "Photoshop") +
                               jpegSegment(0xEB, std::string(65533, 'x')) + jpegSegment(0xFE, "");
  for (const JpegKind& kind : {JpegKind{2, 2, false}, JpegKind{2, 2, true}, JpegKind{1, 1, false, true}}) {
    put(in, jpegOf(texture(40, 40), 40, 40, kind, segments));
    Photograph changed = readPhotograph(in);
    brighten(changed, {3, 3, 20, 20}, {9, 9, 9});
    REQUIRE(writePatchedJpeg(out, in, changed));
    const std::string before = contents(in), after = contents(out);
    CHECK(markersOf(before).size() > segments.size());  // JFIF or Adobe and Exif, too
    CHECK(markersOf(after) == markersOf(before));
    const std::string frame = kind.progressive ? "\xff\xc2" : "\xff\xc0";
    CHECK(after.find(frame + std::string("\0\x11\x08", 3)) != std::string::npos);
  }
}

TEST_CASE("a grey JPEG stays grey with grey light, and cannot take colour") {
  const TemporaryDirectory directory;
  const auto in = directory / "in.jpg", out = directory / "out.jpg";
  put(in, jpegOf(texture(61, 43, 1), 61, 43, {}));
  Photograph original = readPhotograph(in), changed = original, coloured = original;
  brighten(coloured, {13, 9, 50, 34}, {5, 6, 5});
  CHECK(!writePatchedJpeg(out, in, coloured));
  CHECK(directory.names() == std::vector<std::string>{"in.jpg"});

  const Rectangle r{13, 9, 50, 34};
  brighten(changed, r, {20, 20, 20});
  REQUIRE(writePatchedJpeg(out, in, changed));
  CHECK(contents(out).find(std::string("\xff\xc0\0\x0b\x08", 5)) != std::string::npos);  // one component
  Photograph back = readPhotograph(out);
  CHECK(differences(back, original, inUnits(r, {}, true), 0) == 0);
  CHECK(rmsDifference(back, changed, inUnits(r, {}, false)) < mostRms(kStep));
}

TEST_CASE("what cannot be patched is said to be so, and nothing is written") {
  const TemporaryDirectory directory;
  const auto out = directory / "out.jpg";
  // Without the last bits a decoder guesses, but it would not guess about a file that has been written again.
  put(directory / "unfinished.jpg", jpegOf(texture(80, 80), 80, 80, {1, 1, true, false, 1, 0, true}));
  CHECK(!writePatchedJpeg(out, directory / "unfinished.jpg", readPhotograph(directory / "unfinished.jpg")));
  put(directory / "other.png", pngFile({20, 30}, scanLines(asText(texture(20, 30)), 60)));
  CHECK(!writePatchedJpeg(out, directory / "other.png", readPhotograph(directory / "other.png")));

  put(directory / "in.jpg", jpegOf(texture(30, 20), 30, 20, {}));
  Photograph turned = readPhotograph(directory / "in.jpg"), deep = turned;
  std::swap(turned.width, turned.height);
  CHECK_THROWS_AS(static_cast<void>(writePatchedJpeg(out, directory / "in.jpg", turned)), std::invalid_argument);
  deep.samples = std::vector<std::uint16_t>(3 * 30 * 20);
  CHECK_THROWS_AS(static_cast<void>(writePatchedJpeg(out, directory / "in.jpg", deep)), std::invalid_argument);
  CHECK(!std::filesystem::exists(out));
}

TEST_CASE("the strongest changes there can be fit into the coefficients") {
  const TemporaryDirectory directory;
  const auto in = directory / "in.jpg", out = directory / "out.jpg";
  put(in, jpegFile(noiseSamples<std::uint8_t>(3 * 48 * 40), 48, 40, TJPF_RGB, TJSAMP_444, 0, 100));  // steps of 1
  const auto checks = [](int x, int y, int side) { return x / side % 2 == y / side % 2; };
  for (const int side : {1, 4, 8}) {
    Photograph changed = readPhotograph(in);
    for (int i = 0; i < 3 * 48 * 40; ++i) {
      bytesOf(changed)[static_cast<std::size_t>(i)] = checks(i / 3 % 48, i / 3 / 48, side) ? 255 : 0;
    }
    REQUIRE(writePatchedJpeg(out, in, changed));
    Photograph back = readPhotograph(out);
    CHECK(rmsDifference(back, changed, {0, 0, 48, 40}) < mostRms(1));
  }
}

TEST_CASE("subsampled chroma is the mean of the pixels") {
  const TemporaryDirectory directory;
  const auto in = directory / "in.jpg", out = directory / "out.jpg";
  for (const JpegKind& kind : {JpegKind{2, 2}, JpegKind{2, 1}, JpegKind{1, 2}, JpegKind{4, 2}}) {
    CAPTURE(nameOf(kind));
    put(in, jpegOf(texture(160, 96), 160, 96, kind));
    Photograph changed = readPhotograph(in);
    std::array<double, 3> sum{};          // of the errors inside
    for (int i = 0; i < 160 * 96; ++i) {  // red dots on every other pixel, twice as many codes in every other row
      if (i % 2 == 0) bytesOf(changed)[static_cast<std::size_t>(3 * i)] += i / 160 % 2 ? 40 : 80;
    }
    REQUIRE(writePatchedJpeg(out, in, changed));
    Photograph back = readPhotograph(out);
    for (std::size_t i = 0; i < bytesOf(back).size(); ++i) sum[i % 3] += bytesOf(back)[i] - bytesOf(changed)[i];
    // Rounding of the mean to kStep / 8 in Y and in Cb or Cr, which is at most 1.772 of it, everywhere to one side.
    constexpr double kMost = kStep / 16.0 * (1.0 + 1.772);
    for (const double s : sum) CHECK(std::abs(s) / (160 * 96) < kMost);
  }
}

TEST_CASE("a damaged original is an error in one line, and no file comes of it") {
  const TemporaryDirectory directory;
  const auto in = directory / "in.jpg", out = directory / "out.jpg";
  std::mt19937 random(17);
  int refused = 0, written = 0;
  for (const JpegKind& kind : {JpegKind{2, 2, false}, JpegKind{1, 1, true}}) {
    const std::string whole = jpegOf(texture(50, 40), 50, 40, kind);
    put(in, whole);
    const Photograph original = readPhotograph(in);
    for (int i = 0; i < 120; ++i) {
      std::string damaged = i < 25 ? whole.substr(0, whole.size() * static_cast<std::size_t>(i) / 25) : whole;
      if (i >= 25) damaged[random() % std::min<std::size_t>(damaged.size(), 700)] = static_cast<char>(random());
      std::filesystem::remove(in);
      std::filesystem::remove(out);
      put(in, damaged);
      bool done = false;
      try {
        const std::string error = errorOf([&] { done = writePatchedJpeg(out, in, original); });
        CAPTURE(error);
        CHECK((error.empty() || error.find(in.string() + ": ") == 0));
        CHECK(error.find_first_of("\n\r") == std::string::npos);
        refused += error.empty() ? 0 : 1;
      } catch (const std::invalid_argument&) {
        // another size than it had
      }
      written += done ? 1 : 0;
      CHECK(std::filesystem::exists(out) == done);
      if (done) CHECK(errorOf([&] { readPhotograph(out, {.assumeSrgb = true}); }) == "");
    }
  }
  CHECK(refused > 60);
  CHECK(written > 20);
  put(in, jpegOf(texture(50, 40), 50, 40, {}));
  const Photograph sound = readPhotograph(in);
  const auto nowhere = directory / "none" / "out.jpg";
  CHECK(errorOf([&] { static_cast<void>(writePatchedJpeg(nowhere, in, sound)); }) == noFolderFor(nowhere));
}

}  // namespace parhelion
