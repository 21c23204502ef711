// SPDX-License-Identifier: Apache-2.0
// Photographs whose camera, sun and sky are known: what a composite adds to them is held against a render by that
// camera.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include "math/rotation.h"
#include "photographs.h"
#include "picture/exr.h"
#include "picture/photograph.h"
#include "picture/transfer.h"
#include "scene/camera_override.h"
#include "shell.h"
#include "sky/camera.h"

using namespace parhelion;
using namespace parhelion::test;

namespace {

constexpr double kSunElevation = 14.0;  // degrees

const char* kScene = R"([sun]
elevation = 14.0
spectrum = 550.0
[ice]
index = 1.31
[[population]]
shape = "prism"
aspect = 1.0
[[population]]
shape = "prism"
aspect = 0.1
orientation = "plate"
tilt = 1.5
weight = 0.4
[trace]
rays = 1000000
)";

std::string f(const char* format, double a, double b = 0.0) {
  char text[100];
  std::snprintf(text, sizeof text, format, a, b);
  return text;
}

CameraSettings cameraToward(double azimuth, double elevation, double roll) {
  CameraSettings camera;
  camera.projection = Projection::rectilinear;
  camera.fieldOfView = radians(70.0);
  camera.azimuth = radians(azimuth);
  camera.elevation = radians(elevation);
  camera.roll = radians(roll);
  camera.width = 360;
  camera.height = 240;
  return camera;
}

std::string lensFlags(const CameraSettings& camera) {
  const char* axes[] = {"horizontal", "vertical", "diagonal"};
  std::string flags = " --projection " + std::string(nameOf(camera.projection)) + " --fov-" +
                      axes[static_cast<int>(camera.fieldOfViewAxis)] + f(" %.12g", degrees(camera.fieldOfView));
  const Distortion& d = camera.distortion;
  if (!d.none()) flags += f(" --distortion %.12g,%.12g", d.k1, d.k2);
  return flags;
}

std::string sunFlags(const CameraSettings& camera) {
  const auto sun = Camera(camera).placeOf(skyDirection(0.0, radians(kSunElevation)));
  REQUIRE(sun);
  return f(" --sun=%.6f,%.6f", sun->x, sun->y) +
         f(" --sun-elevation %.12g --roll=%.12g", kSunElevation, degrees(camera.roll));
}

/// Sums over squares of 8 pixels a side of a plane; squares at the border are left out where they are cut.
std::vector<double> squares(const std::vector<float>& plane, int width, int height) {
  constexpr int kSide = 8;
  std::vector<double> sums;
  for (int y = 0; y + kSide <= height; y += kSide) {
    for (int x = 0; x + kSide <= width; x += kSide) {
      double sum = 0.0;
      for (int v = y; v < y + kSide; ++v) {
        for (int u = x; u < x + kSide; ++u) sum += plane[static_cast<std::size_t>(v) * width + u];
      }
      sums.push_back(sum);
    }
  }
  return sums;
}

/// The shift (pixels) that brings `truth` nearest to `found`, by least squares on its gradient, within a part of the
/// picture.
Vec2 shiftBetween(const std::vector<float>& found, const std::vector<float>& truth, int width, int left, int right,
                  int top, int bottom) {
  double xx = 0.0, xy = 0.0, yy = 0.0, xd = 0.0, yd = 0.0;
  for (int y = top + 1; y < bottom - 1; ++y) {
    for (int x = left + 1; x < right - 1; ++x) {
      const std::size_t i = static_cast<std::size_t>(y) * width + x;
      const double gx = 0.5 * (truth[i + 1] - truth[i - 1]), gy = 0.5 * (truth[i + width] - truth[i - width]);
      const double d = found[i] - truth[i];
      xx += gx * gx, xy += gx * gy, yy += gy * gy, xd -= gx * d, yd -= gy * d;
    }
  }
  const double determinant = xx * yy - xy * xy;
  return {(yy * xd - xy * yd) / determinant, (xx * yd - xy * xd) / determinant};
}

struct Comparison {
  double light = 0.0;  // of the halo found over that of the truth, where all is sky
  double worst = 0.0;  // rms over squares of the difference, over the mean
  double shift = 0.0;  // pixels, the largest of four quarters of the picture
};

/// What `composite` of photograph and scene added, against the truth: a render by the true camera times `strength`.
Comparison compare(const Folder& folder, const CameraSettings& truth, double strength) {
  const Outcome rendered =
      run(folder, "parhelion render scene.toml --quiet -o truth.exr -D '" + cameraOverride(truth) + "'");
  REQUIRE_MESSAGE(rendered.exit == 0, rendered.err);
  const ExrFile sky = readExr(folder / "truth.exr"), light = readExr(folder / "layers/halo.exr");
  std::vector<float> expected = *sky.image.find("G"), added = *light.image.find("G");
  REQUIRE(expected.size() == added.size());
  for (std::size_t i = 0; i < expected.size(); ++i) expected[i] = static_cast<float>(strength * expected[i]);
  Comparison result;
  const std::vector<double> a = squares(added, truth.width, truth.height),
                            e = squares(expected, truth.width, truth.height);
  double sumA = 0.0, sumE = 0.0, square = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    sumA += a[i], sumE += e[i], square += (a[i] - e[i]) * (a[i] - e[i]);
  }
  result.light = sumA / sumE;
  result.worst = std::sqrt(square / static_cast<double>(a.size())) / (sumE / static_cast<double>(a.size()));
  const int w = truth.width, h = truth.height;
  for (const auto& [l, r, t, b] :
       {std::array{0, w / 2, 0, h / 2}, {w / 2, w, 0, h / 2}, {0, w / 2, h / 2, h}, {w / 2, w, h / 2, h}})
    result.shift = std::max(result.shift, glm::length(shiftBetween(added, expected, w, l, r, t, b)));
  return result;
}

/// A composite of an all-sky photograph by a camera whose lens and sun are given; compared with the truth.
Comparison compositeOf(const CameraSettings& camera, const std::string& flags, const std::string& more = "") {
  Folder folder;
  writeFile(folder / "scene.toml", kScene);
  writePhotograph(folder / "photo.png", landscape<std::uint8_t>(camera.width, camera.height, 2.0), {});
  const Outcome outcome = run(folder,
                              "parhelion composite photo.png --scene scene.toml -o out.png --all-sky "
                              "--strength 0.1 --layers layers --quiet" +
                                  flags + more);
  REQUIRE_MESSAGE(outcome.exit == 0, outcome.err);
  return compare(folder, camera, 0.1);
}

void checkTruth(const Comparison& found) {
  CHECK(std::abs(found.light - 1.0) < 0.01);
  CHECK(found.worst < 0.01);
  CHECK(found.shift < 0.1);  // pixels
}

}  // namespace

TEST_CASE("a composite puts the halo where the camera saw it, and as much light") {
  SUBCASE("looking at the sun") {
    checkTruth(
        compositeOf(cameraToward(0, 20, 0), sunFlags(cameraToward(0, 20, 0)) + lensFlags(cameraToward(0, 20, 0))));
  }
  SUBCASE("tilted, the sun outside the frame") {
    const CameraSettings camera = cameraToward(42, 25, -12);
    CHECK_FALSE(Camera(camera).project(skyDirection(0.0, radians(kSunElevation))));
    checkTruth(compositeOf(camera, sunFlags(camera) + lensFlags(camera)));
  }
  SUBCASE("through a lens with distortion") {
    CameraSettings camera = cameraToward(-8, 18, 5);
    camera.distortion = {-0.12, 0.03, 0.0};
    checkTruth(compositeOf(camera, sunFlags(camera) + lensFlags(camera)));
  }
  SUBCASE("through a fisheye toward the zenith") {
    CameraSettings camera = cameraToward(0, 75, 0);
    camera.projection = Projection::fisheyeEqualArea;
    camera.fieldOfView = radians(150.0);
    camera.height = 360;
    checkTruth(compositeOf(camera, sunFlags(camera) + lensFlags(camera)));
  }
  SUBCASE("upright, the pointing from the horizon and the sun, whose elevation is not told") {
    CameraSettings camera = cameraToward(10, 15, 3);
    std::swap(camera.width, camera.height);
    camera.fieldOfViewAxis = FieldOfViewAxis::vertical;
    const Camera optics(camera);
    const auto a = optics.placeOf(skyDirection(radians(-20.0), 0.0)),
               b = optics.placeOf(skyDirection(radians(35.0), 0.0));
    const auto sun = optics.placeOf(skyDirection(0.0, radians(kSunElevation)));
    checkTruth(compositeOf(camera, lensFlags(camera) + f(" --horizon=%.6f,%.6f", a->x, a->y) +
                                       f(" --horizon=%.6f,%.6f", b->x, b->y) + f(" --sun=%.6f,%.6f", sun->x, sun->y)));
  }
  SUBCASE("on pixels four times as large") {
    const CameraSettings camera = cameraToward(0, 20, 0);
    const Comparison found = compositeOf(camera, sunFlags(camera) + lensFlags(camera), " --coarseness 4");
    CHECK(std::abs(found.light - 1.0) < 0.01);
    CHECK(found.shift < 0.5);
  }
}

TEST_CASE("an upright photograph that is stored on its side has its lens from the EXIF and its halo in place") {
  constexpr double kFilmDiagonal = 43.26661530556787;  // mm, of 36 mm x 24 mm
  CameraSettings camera = cameraToward(5, 20, 0);
  std::swap(camera.width, camera.height);
  camera.fieldOfViewAxis = FieldOfViewAxis::diagonal;
  camera.fieldOfView = 2.0 * std::atan(0.5 * kFilmDiagonal / 28.0);
  const Photograph upright = landscape<std::uint8_t>(camera.width, camera.height, 0.7);
  // Orientation 6: the first row of the file is the right side of the picture, its first column the top.
  Photograph stored = upright;
  std::swap(stored.width, stored.height);
  const auto& from = std::get<std::vector<std::uint8_t>>(upright.samples);
  auto& to = std::get<std::vector<std::uint8_t>>(stored.samples);
  for (int row = 0; row < stored.height; ++row) {
    for (int column = 0; column < stored.width; ++column) {
      for (std::size_t c = 0; c < 3; ++c)
        to[3 * (static_cast<std::size_t>(row) * stored.width + column) + c] =
            from[3 * (static_cast<std::size_t>(column) * upright.width + upright.width - 1 - row) + c];
    }
  }
  Folder folder;
  writeFile(folder / "scene.toml", kScene);
  writeJpegWithExif(folder / "photo.jpg", stored, 6, 28);
  const Outcome outcome = run(folder,
                              "parhelion composite photo.jpg --scene scene.toml -o out.png --all-sky --strength 0.1 "
                              "--layers layers --quiet" +
                                  sunFlags(camera));
  REQUIRE_MESSAGE(outcome.exit == 0, outcome.err);
  checkTruth(compare(folder, camera, 0.1));
  CHECK(readPhotograph(folder / "out.png").width == camera.width);
}

TEST_CASE("a halo rendered by another camera lands on the same pixels") {
  Folder folder;
  writeFile(folder / "scene.toml", kScene);
  const CameraSettings camera = cameraToward(-15, 22, 7);
  writePhotograph(folder / "photo.png", landscape<std::uint8_t>(camera.width, camera.height, 2.0), {});
  const Outcome outcome = run(folder,
                              "parhelion render scene.toml --quiet -o sky.exr -D camera.resolution=[1200,1200] "
                              "-D camera.fov_horizontal=250 && "
                              "parhelion composite photo.png --halo sky.exr -o out.png --all-sky --strength 0.1 "
                              "--layers layers --quiet" +
                                  sunFlags(camera) + lensFlags(camera));
  REQUIRE_MESSAGE(outcome.exit == 0, outcome.err);
  const ExrFile light = readExr(folder / "layers/halo.exr");
  const Comparison found = compare(folder, camera, 0.1);
  CHECK(std::abs(found.light - 1.0) < 0.01);
  CHECK(found.shift < 0.5);  // pixels
}

TEST_CASE("what is not sky and what no halo touches keeps its bits") {
  Folder folder;
  writeFile(folder / "scene.toml", kScene);
  const CameraSettings camera = cameraToward(0, 20, 0);
  const Photograph photograph = landscape<std::uint16_t>(camera.width, camera.height, 0.6);
  writePhotograph(folder / "photo.png", photograph, {});
  writePhotograph(folder / "mask.png", skyOf(camera.width, camera.height, 0.6), {});
  const Outcome outcome =
      run(folder, "parhelion composite photo.png --scene scene.toml -o out.png --mask mask.png --quiet" +
                      sunFlags(camera) + lensFlags(camera));
  REQUIRE_MESSAGE(outcome.exit == 0, outcome.err);
  const Photograph out = readPhotograph(folder / "out.png"), mask = readPhotograph(folder / "mask.png");
  const auto &before = std::get<std::vector<std::uint16_t>>(photograph.samples),
             &after = std::get<std::vector<std::uint16_t>>(out.samples);
  const auto& sky = std::get<std::vector<std::uint8_t>>(mask.samples);
  REQUIRE(after.size() == before.size());
  std::size_t changedLand = 0, changedSky = 0, skyPixels = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    (sky[i] == 0 ? changedLand : changedSky) += before[i] != after[i];
    skyPixels += sky[i] != 0;
  }
  CHECK(changedLand == 0);
  CHECK(changedSky > skyPixels / 2);
}

TEST_CASE("a picture of 8 bits gets the halo's light, however little of a code it is") {
  Folder folder;
  writeFile(folder / "scene.toml", kScene);
  const CameraSettings camera = cameraToward(0, 20, 0);
  Photograph flat = landscape<std::uint8_t>(camera.width, camera.height, 2.0);
  for (std::uint8_t& sample : std::get<std::vector<std::uint8_t>>(flat.samples)) sample = 120;
  writePhotograph(folder / "photo.png", flat, {});
  const Outcome outcome = run(folder,
                              "parhelion composite photo.png --scene scene.toml -o out.png --all-sky --layers layers "
                              "--strength 0.004 --quiet" +
                                  sunFlags(camera) + lensFlags(camera));
  REQUIRE_MESSAGE(outcome.exit == 0, outcome.err);
  const Photograph out = readPhotograph(folder / "out.png");
  const ExrFile light = readExr(folder / "layers/halo.exr");
  double wanted = 0.0, added = 0.0, least = 1.0;
  for (std::size_t i = 0; i < out.pixels(); ++i) {
    wanted += (*light.image.find("G"))[i];
    added += srgbDecode8()[std::get<std::vector<std::uint8_t>>(out.samples)[3 * i + 1]] - srgbDecode8()[120];
  }
  least = wanted / static_cast<double>(out.pixels()) / (srgbDecode8()[121] - srgbDecode8()[120]);
  CHECK(least < 0.5);  // rounding would leave most of it out
  // The dither's standard error: at most half a code in each of 86400 pixels.
  const double sigma = 0.5 * (srgbDecode8()[121] - srgbDecode8()[120]) * std::sqrt(static_cast<double>(out.pixels()));
  CHECK(std::abs(added - wanted) < 4.0 * sigma);
}
