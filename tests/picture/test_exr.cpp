// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <ImfChromaticitiesAttribute.h>
#include <ImfInputFile.h>
#include <ImfStandardAttributes.h>

#include <cmath>
#include <cstdlib>
#include <random>

#include "picture/exr.h"
#include "sky/tally_exr.h"
#include "temporary_directory.h"

namespace parhelion {
namespace {

Image picture(int width, int height) {
  Image image{width, height, {}};
  std::mt19937 random(6);
  std::normal_distribution<float> normal;
  for (const char* name : {"R", "G", "B", "Variance.Y"}) {
    for (float& sample : image.add(name)) sample = normal(random);
  }
  return image;
}

Tally tally(int colours) {
  TallyInfo info;
  info.seed = 0xfedcba9876543210;
  info.rays = {{0, 1000}, {5000, 17}};
  info.sceneHash = 0x0fedcba987654321;
  info.numerics = 7;
  info.intercepted = LightTotal(toFixed(1017.0) + 5);
  info.undeviated = LightTotal(77);
  info.interceptedXyz.fill(info.intercepted);
  info.white = {0.1 + 0.2, 1.0, 1.0 / 3.0};
  info.sunElevation = radians(20.0);
  info.sunDiameter = radians(0.533);
  info.camera.projection = Projection::fisheyeStereographic;
  info.camera.fieldOfViewAxis = FieldOfViewAxis::diagonal;
  info.camera.fieldOfView = radians(123.4);
  info.camera.azimuth = -1e-17;
  info.camera.roll = 1e300;
  info.camera.width = 37;
  info.camera.height = 35;
  info.scene = "[sun]\nelevation = 20.0  # \xc3\xa9\n";
  info.version = "0.1.0";
  Tally t(info, colours);
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> light(0.0, 0.3);
  for (int i = 0; i < 2000; ++i)
    t.add(static_cast<int>(random() % static_cast<unsigned>(t.pixels())),
          Vec3(light(random), light(random), light(random)), i % 2 == 0);
  return t;
}

/// Reading `bytes` from a file must end in an error of one line with its path and `reason`, never in anything else.
template <typename Reader>
void checkRefused(const std::filesystem::path& path, const std::string& bytes, Reader reader,
                  const std::string& reason = "") {
  put(path, bytes);
  const std::string error = errorOf([&] { reader(path); });
  CAPTURE(error);
  CHECK(error.find(path.string() + ": ") == 0);
  CHECK(error.find(reason) != std::string::npos);
  CHECK(error.size() > path.string().size() + 5);
  CHECK(error.find('\n') == std::string::npos);
}

/// Lengths at which a file is cut, bytes: densely up to about where its header ends.
struct Cuts {
  std::size_t header, step, stepAfter;
};

/// A file cut anywhere is refused, and so is one that lacks its last byte.
template <typename Reader>
void checkCutsRefused(const std::filesystem::path& path, const std::string& whole, Reader reader, const Cuts& cuts) {
  for (std::size_t length = 0; length < whole.size(); length += length < cuts.header ? cuts.step : cuts.stepAfter) {
    CAPTURE(length);
    checkRefused(path, whole.substr(0, length), reader);
  }
  checkRefused(path, whole.substr(0, whole.size() - 1), reader);
}

const auto kReadPicture = [](const std::filesystem::path& path) { readExr(path); };
const auto kReadTally = [](const std::filesystem::path& path) { readTallyExr(path); };

}  // namespace

TEST_CASE("a picture comes back from its file as it was, with its attributes") {
  const TemporaryDirectory directory;
  const auto path = directory / "out.exr";
  const Image image = picture(53, 41);
  const ExrAttributes attributes = {{"software", "Parhelion 0.1.0"}, {"parhelion:scene", "[sun]\nelevation = 20\n"}};
  writeBeautyExr(path, image, attributes);
  const ExrFile back = readExr(path);
  CHECK(back.image.width == 53);
  CHECK(back.image.height == 41);
  REQUIRE(back.image.channels.size() == 4);
  for (const Channel& channel : image.channels) {
    REQUIRE(back.image.find(channel.name) != nullptr);
    CHECK(*back.image.find(channel.name) == channel.samples);
  }
  CHECK(back.attributes == attributes);
  CHECK(directory.names().size() == 1);
}

TEST_CASE(
    "in ACEScg red, green and blue of Rec.709 have the values of other programs, and come back, layers with them") {
  const TemporaryDirectory directory;
  const std::filesystem::path path = directory / "acescg.exr";
  Image image{4, 1, {}};
  for (const char* layer : {"", "halo."})
    for (std::size_t c = 0; c < 3; ++c) {
      std::vector<float>& plane = image.add(std::string(layer) + "RGB"[c]);
      plane[c] = plane[3] = 1.0F;
    }
  image.add("Variance.Y")[0] = 0.5F;
  writeBeautyExr(path, image, {}, Envmap::none, kAcesCgChromaticities);
  const ExrFile stored = readExr(path, ExrColours::asStored), back = readExr(path);
  REQUIRE(stored.chromaticities);
  CHECK(stored.chromaticities->green.y == doctest::Approx(0.83));
  // The matrix that is in use for this, by a Bradford adaptation.
  const double known[3][4] = {
      {0.6131, 0.3395, 0.0474, 1.0}, {0.0702, 0.9164, 0.0135, 1.0}, {0.0206, 0.1096, 0.8698, 1.0}};
  for (const char* layer : {"", "halo."})
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t i = 0; i < 4; ++i) {
        const std::string name = std::string(layer) + "RGB"[c];
        CHECK(std::abs((*stored.image.find(name))[i] - known[c][i]) < 2e-4);
        CHECK(std::abs((*back.image.find(name))[i] - (*image.find(name))[i]) < 1e-6);
      }
  CHECK(*stored.image.find("Variance.Y") == *image.find("Variance.Y"));
}

TEST_CASE("the luminance of white is a number of OpenEXR's own in the file, and comes back as text") {
  const TemporaryDirectory directory;
  const std::filesystem::path path = directory / "a.exr";
  writeBeautyExr(path, picture(3, 2), {{"software", "s"}, {kWhiteLuminanceKey, "0.25"}});
  {
    const Imf::InputFile file(path.c_str());
    REQUIRE(Imf::hasWhiteLuminance(file.header()));
    CHECK(Imf::whiteLuminance(file.header()) == 0.25F);
  }
  CHECK(whiteLuminanceOf(readExr(path).attributes) == 0.25);
  CHECK(whiteLuminanceOf(readExrAttributes(path)) == 0.25);
  writeBeautyExr(path, picture(3, 2), {{"software", "s"}});
  CHECK_FALSE(whiteLuminanceOf(readExr(path).attributes));
  for (const char* none : {"0", "-1", "nan", "bright", ""}) CHECK_FALSE(whiteLuminanceOf({{kWhiteLuminanceKey, none}}));
}

TEST_CASE("a picture's file says Rec.709 and is the same bytes each time, dated by SOURCE_DATE_EPOCH") {
  const TemporaryDirectory directory;
  writeBeautyExr(directory / "a.exr", picture(20, 20), {});
  writeBeautyExr(directory / "b.exr", picture(20, 20), {});
  CHECK(contents(directory / "a.exr") == contents(directory / "b.exr"));
  const Imf::InputFile file((directory / "a.exr").c_str());
  REQUIRE(Imf::hasChromaticities(file.header()));
  CHECK(Imf::chromaticities(file.header()).red == Imath::V2f(0.64F, 0.33F));
  CHECK(Imf::chromaticities(file.header()).white == Imath::V2f(0.3127F, 0.3290F));
  ::setenv("SOURCE_DATE_EPOCH", "1700000000", 1);
  writeBeautyExr(directory / "a.exr", picture(20, 20), {});
  ::setenv("SOURCE_DATE_EPOCH", "soon", 1);
  const std::string error = errorOf([&] { writeBeautyExr(directory / "a.exr", picture(20, 20), {}); });
  ::unsetenv("SOURCE_DATE_EPOCH");
  CHECK(error.find("SOURCE_DATE_EPOCH") == 0);
  CHECK(readExr(directory / "a.exr").attributes.at("capDate") == "2023:11:14 22:13:20");
}

TEST_CASE("a tally comes back from its file bit for bit") {
  const TemporaryDirectory directory;
  for (const int colours : {1, 3}) {
    const Tally original = tally(colours);
    writeTallyExr(directory / "tally.exr", original);
    CHECK(readTallyExr(directory / "tally.exr") == original);
    writeTallyExr(directory / "again.exr", original);
    CHECK(contents(directory / "tally.exr") == contents(directory / "again.exr"));
  }
}

TEST_CASE("other pictures are no tallies") {
  const TemporaryDirectory directory;
  writeBeautyExr(directory / "picture.exr", picture(8, 8), {});
  CHECK(errorOf([&] { readTallyExr(directory / "picture.exr"); }) ==
        (directory / "picture.exr").string() + ": not a tally of Parhelion");
}

TEST_CASE("a file cut off anywhere is refused with its path") {
  const TemporaryDirectory directory;
  writeBeautyExr(directory / "whole.exr", picture(31, 40), {{"parhelion:scene", "[sun]"}});
  const std::string whole = contents(directory / "whole.exr");
  checkCutsRefused(directory / "cut.exr", whole, kReadPicture, {.header = 1000, .step = 3, .stepAfter = 197});

  writeTallyExr(directory / "tally.exr", tally(3));
  const std::string sums = contents(directory / "tally.exr");
  checkCutsRefused(directory / "cut.exr", sums, kReadTally, {.header = 3000, .step = 7, .stepAfter = 1013});
}

TEST_CASE("damaged files end in an error or a picture, never in a crash") {
  const TemporaryDirectory directory;
  writeBeautyExr(directory / "whole.exr", picture(16, 20), {{"parhelion:scene", "[sun]"}});
  writeTallyExr(directory / "tally.exr", tally(1));
  const std::string picture16 = contents(directory / "whole.exr"), sums = contents(directory / "tally.exr");
  std::mt19937 random(8);
  int refused = 0;
  for (int i = 0; i < 1000; ++i) {
    const bool asTally = i % 2 == 0;
    std::string bytes = asTally ? sums : picture16;
    // mostly in the header, where the lies are
    const std::size_t range = i % 8 < 6 ? std::min<std::size_t>(bytes.size(), 1500) : bytes.size();
    for (int k = 0; k <= i % 3; ++k) bytes[random() % range] = static_cast<char>(i % 5 == 0 ? 0xff : random());
    put(directory / "bad.exr", bytes);
    const std::string error =
        errorOf([&] { asTally ? kReadTally(directory / "bad.exr") : kReadPicture(directory / "bad.exr"); });
    refused += error.empty() ? 0 : 1;
    if (!error.empty()) CHECK(error.find((directory / "bad.exr").string()) == 0);
  }
  CHECK(refused > 300);
}

TEST_CASE("a header that promises a huge picture or a huge attribute is refused before memory is taken") {
  const TemporaryDirectory directory;
  writeBeautyExr(directory / "whole.exr", picture(16, 20), {{"parhelion:scene", "[sun]"}});
  const std::string whole = contents(directory / "whole.exr");
  const auto withNumberAt = [&](const std::string& after, std::size_t offset, std::int32_t number) {
    std::string bytes = whole;
    const std::size_t at = bytes.find(after) + after.size() + offset;
    for (std::size_t k = 0; k < 4; ++k) bytes[at + k] = static_cast<char>(static_cast<std::uint32_t>(number) >> 8 * k);
    return bytes;
  };
  const std::string window("dataWindow\0box2i\0", 17), scene("parhelion:scene\0string\0", 23);
  checkRefused(directory / "bad.exr", withNumberAt(window, 12, 30'000), kReadPicture, "promises more pixels");
  checkRefused(directory / "bad.exr", withNumberAt(window, 16, 30'000), kReadPicture);
  checkRefused(directory / "bad.exr", withNumberAt(window, 16, 0x7fffffff), kReadPicture);
  checkRefused(directory / "bad.exr", withNumberAt(window, 4, -0x7fffffff), kReadPicture);
  checkRefused(directory / "bad.exr", withNumberAt(window, 12, -5), kReadPicture);
  checkRefused(directory / "bad.exr", withNumberAt(scene, 0, 0x7fffffff), kReadPicture, "header is damaged");
  checkRefused(directory / "bad.exr", withNumberAt(scene, 0, -1), kReadPicture, "header is damaged");
}

TEST_CASE("what is no EXR is refused, and so are directories and missing files") {
  const TemporaryDirectory directory;
  for (const std::string& bytes :
       {std::string(), std::string("v/1"), std::string(5000, '\0'), std::string(9000, 'x')}) {
    checkRefused(directory / "bad.exr", bytes, kReadPicture);
    checkRefused(directory / "bad.exr", bytes, kReadTally);
  }
  CHECK(errorOf([&] { readExr(directory / "none.exr"); }) ==
        (directory / "none.exr").string() + ": No such file or directory");
  CHECK(errorOf([&] { readExr(directory / "."); }).find("not a regular file") != std::string::npos);
}

TEST_CASE("pictures and tallies that cannot be written are told, and damage nothing") {
  const TemporaryDirectory directory;
  const auto missing = directory / "none" / "out.exr";
  CHECK(errorOf([&] { writeBeautyExr(missing, picture(4, 4), {}); }) == noFolderFor(missing));
  CHECK(errorOf([&] { writeTallyExr(missing, tally(1)); }) == noFolderFor(missing));
  // Large enough that OpenEXR meets the error itself, and small enough that only the last flush does.
  for (const int size : {4, 300}) {
    CHECK(errorOf([&] { writeBeautyExr("/dev/full", picture(size, size), {}); }) ==
          "/dev/full: No space left on device");
  }
  CHECK(errorOf([&] { writeTallyExr("/dev/full", tally(3)); }) == "/dev/full: No space left on device");
}

}  // namespace parhelion
