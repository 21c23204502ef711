// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfOutputFile.h>
#include <ImfStandardAttributes.h>

#include <array>

#include "picture/photograph.h"
#include "temporary_directory.h"

namespace parhelion {
namespace {

using Box = Imath::Box2i;

/// Writes planes in which sample i of channel k is k + i / 1024, exact in halves.
void writeExr(const std::filesystem::path& path, const std::vector<std::string>& names, Box display, Box data,
              Imf::Compression compression = Imf::ZIP_COMPRESSION,
              const Imf::Chromaticities* chromaticities = nullptr) {
  Imf::Header header(display, data);
  header.compression() = compression;
  if (chromaticities) Imf::addChromaticities(header, *chromaticities);
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

TEST_CASE("an EXR with other primaries is refused unless one insists") {
  const TemporaryDirectory directory;
  const auto path = directory / "in.exr";
  const Imf::Chromaticities aces({0.7347F, 0.2653F}, {0.0F, 1.0F}, {0.0001F, -0.077F}, {0.32168F, 0.33767F});
  writeExr(path, {"R", "G", "B"}, kSmall, kSmall, Imf::ZIP_COMPRESSION, &aces);
  const std::string error = errorOf([&] { readPhotograph(path); });
  CHECK(error.find("its colours have the primaries red (0.7347, 0.2653), green (0, 1)") != std::string::npos);
  CHECK(error.find("--assume-srgb") != std::string::npos);
  CHECK(readPhotograph(path, {.assumeSrgb = true}).width == 10);
  const Imf::Chromaticities rounded({0.64F, 0.33F}, {0.30F, 0.60F}, {0.15F, 0.06F}, {0.313F, 0.329F});
  writeExr(path, {"R", "G", "B"}, kSmall, kSmall, Imf::ZIP_COMPRESSION, &rounded);
  CHECK(readPhotograph(path).width == 10);
}

}  // namespace parhelion
