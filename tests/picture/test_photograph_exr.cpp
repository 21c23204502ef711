// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfOutputFile.h>
#include <ImfStandardAttributes.h>

#include <array>
#include <cmath>
#include <limits>

#include "picture/exr.h"
#include "picture/photograph.h"
#include "temporary_directory.h"

namespace parhelion {
namespace {

using Box = Imath::Box2i;

/// Writes planes in which sample i of channel k is k + i / 1024, exact in halves.
void writeExr(const std::filesystem::path& path, const std::vector<std::string>& names, Box display, Box data,
              Imf::Compression compression = Imf::ZIP_COMPRESSION) {
  Imf::Header header(display, data);
  header.compression() = compression;
  const auto count = static_cast<std::size_t>((data.max.x - data.min.x + 1) * (data.max.y - data.min.y + 1));
  std::vector<std::vector<float>> planes;
  Imf::FrameBuffer buffer;
  for (std::size_t k = 0; k < names.size(); ++k) {
    planes.emplace_back(count);
    for (std::size_t i = 0; i < count; ++i) planes[k][i] = static_cast<float>(k) + static_cast<float>(i) / 1024.0F;
    header.channels().insert(names[k], Imf::Channel(Imf::FLOAT));
    buffer.insert(names[k], Imf::Slice::Make(Imf::FLOAT, planes[k].data(), data));
  }
  Imf::OutputFile file(path.c_str(), header);
  file.setFrameBuffer(buffer);
  file.writePixels(data.max.y - data.min.y + 1);
}

const Box kSmall(Imath::V2i(0, 0), Imath::V2i(9, 7));

std::vector<float> floatsOf(const Photograph& photograph) { return std::get<std::vector<float>>(photograph.samples); }

}  // namespace

TEST_CASE("an EXR has its colours in R, G, B or Y, its alpha in A, and other channels do not matter") {
  const TemporaryDirectory directory;
  const auto path = directory / "in.exr";
  writeExr(path, {"B", "G", "Z", "R", "A"}, kSmall, kSmall);
  const Photograph colour = readPhotograph(path);
  CHECK(colour.channels == 4);
  for (const std::size_t c : {0, 1, 2, 3}) CHECK(floatsOf(colour)[c] == std::array{3.0F, 1.0F, 0.0F, 4.0F}[c]);
  writeExr(path, {"Y"}, kSmall, kSmall);
  const Photograph grey = readPhotograph(path);
  CHECK(grey.channels == 3);
  CHECK(floatsOf(grey)[3] == 1.0F / 1024.0F);
  CHECK(floatsOf(grey)[5] == 1.0F / 1024.0F);
  writeExr(path, {"R", "G", "halo.B"}, kSmall, kSmall);
  CHECK(errorOf([&] { readPhotograph(path); }) == path.string() + ": no channels R, G, B, nor Y; it has G, R, halo.B");
}

TEST_CASE("every compression of EXR is read") {
  const TemporaryDirectory directory;
  for (int kind = 0; kind < Imf::NUM_COMPRESSION_METHODS; ++kind) {
    CAPTURE(kind);
    writeExr(directory / "in.exr", {"R", "G", "B"}, kSmall, kSmall, static_cast<Imf::Compression>(kind));
    const Photograph back = readPhotograph(directory / "in.exr");
    const bool lossy = kind == Imf::DWAA_COMPRESSION || kind == Imf::DWAB_COMPRESSION || kind == Imf::PXR24_COMPRESSION;
    // What DWA may lose at its default level; PXR24 keeps 24 of 32 bits.
    CHECK(floatsOf(back).back() == doctest::Approx(2.0 + 79.0 / 1024.0).epsilon(lossy ? 0.02 : 1e-7));
  }
}

TEST_CASE("large flat pictures packed by DWA are not taken for lies") {
  const TemporaryDirectory directory;
  const auto path = directory / "flat.exr";
  const Box large(Imath::V2i(0, 0), Imath::V2i(2999, 1999));
  Imf::Header header(large, large);
  header.compression() = Imf::DWAB_COMPRESSION;
  const std::vector<float> plane(3000 * 2000);
  Imf::FrameBuffer buffer;
  for (const char* name : {"R", "G", "B"}) {
    header.channels().insert(name, Imf::Channel(Imf::FLOAT));
    buffer.insert(name, Imf::Slice::Make(Imf::FLOAT, plane.data(), large));
  }
  {
    Imf::OutputFile file(path.c_str(), header);
    file.setFrameBuffer(buffer);
    file.writePixels(2000);
  }
  CAPTURE(std::filesystem::file_size(path));
  CHECK(readPhotograph(path).width == 3000);
}

TEST_CASE("an EXR is seen through its display window") {
  const TemporaryDirectory directory;
  const auto path = directory / "in.exr";
  const Box full(Imath::V2i(-10, 5), Imath::V2i(9, 14));  // 20 x 10
  // Part of it, with borders outside on the left and at the bottom.
  const Box part(Imath::V2i(-12, 9), Imath::V2i(-3, 20));  // 10 x 12
  writeExr(path, {"R", "G", "B"}, full, part);
  const Photograph back = readPhotograph(path);
  REQUIRE(back.width == 20);
  REQUIRE(back.height == 10);
  const auto samples = floatsOf(back);
  for (int y = 0; y < 10; ++y) {
    for (int x = 0; x < 20; ++x) {
      const int column = x - 10 + 12, row = y + 5 - 9;
      const bool inside = column < 10 && row >= 0;
      const float green = samples[static_cast<std::size_t>(3 * (20 * y + x) + 1)];
      CHECK(green == (inside ? 1.0F + static_cast<float>(10 * row + column) / 1024.0F : 0.0F));
    }
  }
  writeExr(path, {"R", "G", "B"}, full, Box(Imath::V2i(100, 100), Imath::V2i(101, 103)));
  for (const float sample : floatsOf(readPhotograph(path))) CHECK(sample == 0.0F);
  writeExr(path, {"R", "G", "B"}, Box(Imath::V2i(0, 0), Imath::V2i(9999, 9999)), kSmall);
  CHECK(errorOf([&] { readPhotograph(path); }) ==
        path.string() + ": the display window is far larger than the picture in it");
}

namespace {

// SMPTE ST 2065-1 and Academy S-2014-004 (AP0, AP1), SMPTE EG 432-1 (P3, with D65), ITU-R BT.2020.
const Imf::Chromaticities kAp0({0.7347F, 0.2653F}, {0.0F, 1.0F}, {0.0001F, -0.077F}, {0.32168F, 0.33767F});
const Imf::Chromaticities kAp1({0.713F, 0.293F}, {0.165F, 0.830F}, {0.128F, 0.044F}, {0.32168F, 0.33767F});
const Imf::Chromaticities kP3({0.680F, 0.320F}, {0.265F, 0.690F}, {0.150F, 0.060F}, {0.3127F, 0.3290F});
const Imf::Chromaticities kRec2020({0.708F, 0.292F}, {0.170F, 0.797F}, {0.131F, 0.046F}, {0.3127F, 0.3290F});

/// A picture of one pixel with alpha, whose samples are of that type.
template <class Sample>
void writePixel(const std::filesystem::path& path, const std::array<float, 4>& rgba,
                const Imf::Chromaticities& colours) {
  Imf::Header header(1, 1);
  Imf::addChromaticities(header, colours);
  constexpr Imf::PixelType type = sizeof(Sample) == 2 ? Imf::HALF : Imf::FLOAT;
  std::array<Sample, 4> samples{Sample(rgba[0]), Sample(rgba[1]), Sample(rgba[2]), Sample(rgba[3])};
  Imf::FrameBuffer buffer;
  for (std::size_t k = 0; k < 4; ++k) {
    const std::string name(1, "RGBA"[k]);
    header.channels().insert(name, Imf::Channel(type));
    buffer.insert(name, Imf::Slice(type, reinterpret_cast<char*>(&samples[k]), sizeof(Sample), sizeof(Sample)));
  }
  Imf::OutputFile file(path.c_str(), header);
  file.setFrameBuffer(buffer);
  file.writePixels(1);
}

}  // namespace

TEST_CASE("an EXR of other primaries is converted to Rec.709, its white to white") {
  const TemporaryDirectory directory;
  const auto path = directory / "in.exr";
  struct Case {
    const Imf::Chromaticities& colours;
    std::array<float, 3> stored, rec709;
  };
  // Rows of the matrices that the ACES project publishes (AP0 and AP1 to Rec.709 by Bradford), of ITU-R BT.2087 for
  // Rec.2020, and of Display P3, to four digits.
  const Case cases[] = {
      {kAp1, {0.2F, 0.5F, 0.1F}, {0.0218F, 0.5433F, 0.0460F}},
      {kAp1, {1.0F, 0.0F, 0.0F}, {1.7051F, -0.1302F, -0.0240F}},
      {kAp0, {1.0F, 0.0F, 0.0F}, {2.5217F, -0.2765F, -0.0154F}},
      {kAp0, {0.0F, 1.0F, 0.0F}, {-1.1341F, 1.3727F, -0.1530F}},
      {kP3, {1.0F, 0.0F, 0.0F}, {1.2249F, -0.0420F, -0.0197F}},
      {kRec2020, {1.0F, 0.0F, 0.0F}, {1.6605F, -0.1246F, -0.0182F}},
      {kRec2020, {0.0F, 0.0F, 1.0F}, {-0.0728F, -0.0083F, 1.1187F}},
  };
  for (const auto& [colours, stored, rec709] : cases) {
    writePixel<float>(path, {stored[0], stored[1], stored[2], 0.5F}, colours);
    const std::vector<float> samples = floatsOf(readPhotograph(path));
    const ExrFile file = readExr(path);
    for (std::size_t c = 0; c < 3; ++c) {
      CHECK(std::abs(samples[c] - rec709[c]) <= 1e-4F);
      CHECK((*file.image.rgb()[c])[0] == samples[c]);
      CHECK((*readExr(path, ExrColours::asStored).image.rgb()[c])[0] == stored[c]);
      CHECK(floatsOf(readPhotograph(path, {.assumeSrgb = true}))[c] == stored[c]);
    }
    CHECK(samples[3] == 0.5F);
    writePixel<half>(path, {0.75F, 0.75F, 0.75F, 1.0F}, colours);
    const std::vector<float> white = floatsOf(readPhotograph(path));
    for (std::size_t c = 0; c < 3; ++c) CHECK(white[c] == doctest::Approx(0.75).epsilon(1e-6));
  }
}

TEST_CASE("pixels of other primaries that hold no numbers stay as they are") {
  const TemporaryDirectory directory;
  const auto path = directory / "in.exr";
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  writePixel<float>(path, {kInfinity, 1.0F, 2.0F, 1.0F}, kAp0);
  CHECK(floatsOf(readPhotograph(path)) == std::vector<float>{kInfinity, 1.0F, 2.0F, 1.0F});
}

TEST_CASE("primaries that make no colour space are refused unless one insists") {
  const TemporaryDirectory directory;
  const auto path = directory / "in.exr";
  const float nan = std::nanf("");
  const Imf::Chromaticities none[] = {
      {{0.3F, 0.3F}, {0.3F, 0.3F}, {0.3F, 0.3F}, {0.3127F, 0.3290F}},
      {{0.1F, 0.1F}, {0.2F, 0.2F}, {0.3F, 0.3F}, {0.3127F, 0.3290F}},
      {{0.64F, 0.33F}, {0.30F, 0.60F}, {0.15F, 0.06F}, {0.7F, 0.3F}},
      {{0.64F, 0.33F}, {0.30F, 0.60F}, {0.15F, 0.06F}, {0.3127F, 0.0F}},
      {{nan, 0.33F}, {0.30F, 0.60F}, {0.15F, 0.06F}, {0.3127F, 0.3290F}},
  };
  for (const Imf::Chromaticities& colours : none) {
    writePixel<float>(path, {0.1F, 0.2F, 0.3F, 1.0F}, colours);
    const std::string error = errorOf([&] { readPhotograph(path); });
    CHECK(error.find("its colours have the primaries red (") != std::string::npos);
    CHECK(error.find("make no colour space; --assume-srgb") != std::string::npos);
    CHECK(floatsOf(readPhotograph(path, {.assumeSrgb = true}))[2] == 0.3F);
  }
}

TEST_CASE("primaries that were rounded are still those of Rec.709, and no sample changes") {
  const TemporaryDirectory directory;
  const auto path = directory / "in.exr";
  writePixel<float>(path, {0.1F, 0.2F, 0.3F, 1.0F}, {{0.64F, 0.33F}, {0.30F, 0.60F}, {0.15F, 0.06F}, {0.313F, 0.329F}});
  CHECK(floatsOf(readPhotograph(path)) == std::vector<float>{0.1F, 0.2F, 0.3F, 1.0F});
}

}  // namespace parhelion
