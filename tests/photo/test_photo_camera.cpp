// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>

#include "error_text.h"
#include "photo/photo_camera.h"
#include "pointing_cameras.h"

namespace parhelion {
namespace {

Photograph sized(int width, int height) {
  Photograph photograph;
  photograph.width = width;
  photograph.height = height;
  return photograph;
}

Vec2 placeOf(const CameraSettings& camera, double azimuth, double elevation) {
  return Camera(camera).placeOf(skyDirection(azimuth, elevation)).value();
}

}  // namespace

TEST_CASE("a lens is as it is known, else as the Exif tells, else unknown") {
  const Photograph photograph = sized(600, 400);
  LensClues clues;
  CHECK_FALSE(findLens(photograph, clues));

  clues.focal35mm = 28.0;
  const double focal = 28.0 * std::hypot(600.0, 400.0) / std::hypot(36.0, 24.0);
  const PhotoLens film = findLens(photograph, clues).value();
  CHECK(Camera(film.camera).focalLength() == doctest::Approx(focal).epsilon(1e-11));
  CHECK(film.remark ==
        "lens: 466.7 pixels, 65.5 degrees from left to right, 28 mm on 35 mm film; from 35 mm equivalent 28 mm");

  Photograph told = photograph;
  told.exif.focalLength35mm = 28.0;
  CHECK(findLens(told, {}).value().camera == film.camera);

  clues = {};
  clues.fieldOfView = {FieldOfViewAxis::vertical, radians(50.0)};
  const PhotoLens known = findLens(told, clues).value();
  CHECK(Camera(known.camera).focalLength() == doctest::Approx(200.0 / std::tan(radians(25.0))).epsilon(1e-12));
  CHECK(known.remark == "lens: 428.9 pixels, 69.9 degrees from left to right, 25.7 mm on 35 mm film");

  clues = {};
  clues.projection = Projection::equirectangular;
  CHECK(findLens(sized(800, 400), clues).value().camera.fieldOfView == 2.0 * kPi);
  CHECK(findLens(sized(800, 400), clues).value().remark == "lens: 127.3 pixels, 360.0 degrees from left to right");
}

TEST_CASE("a lens is described by what it sees, which of a circular fisheye is its circle") {
  CameraSettings fisheye;
  fisheye.projection = Projection::fisheyeEquidistant;
  fisheye.width = 600;
  fisheye.height = 400;
  fisheye.fieldOfViewAxis = FieldOfViewAxis::vertical;
  fisheye.fieldOfView = kPi;
  CHECK(describeLens(fisheye) == "lens: 127.3 pixels, 180.0 degrees across its image circle, 7.64 mm on 35 mm film");
  fisheye.fieldOfViewAxis = FieldOfViewAxis::diagonal;
  CHECK(contains(describeLens(fisheye), ", 149.8 degrees from left to right, "));
}

TEST_CASE(
    "sun and horizon point a camera and measure how high the sun stands, and a scene's sun does not matter then") {
  CameraSettings truth = landscape();
  truth.azimuth = radians(8.0);
  truth.elevation = radians(12.0);
  truth.roll = radians(-3.0);
  PointingClues clues;
  clues.sun = placeOf(truth, 0.0, radians(17.0));
  clues.horizon = {placeOf(truth, radians(-10.0), 0.0), placeOf(truth, radians(25.0), 0.0)};
  clues.sceneSunElevation = radians(40.0);
  const PhotoCamera found = pointLens(truth, clues).value();
  CHECK(found.sunIsMeasured);
  CHECK(std::abs(found.sunElevation - radians(17.0)) < 1e-9);
  CHECK(std::abs(found.camera.azimuth - truth.azimuth) < 1e-9);
  CHECK(std::abs(found.camera.elevation - truth.elevation) < 1e-9);
  CHECK(std::abs(found.camera.roll - truth.roll) < 1e-9);
  CHECK(found.remarks.size() == 2);

  clues.sunElevation = radians(17.0);
  const PhotoCamera said = pointLens(truth, clues).value();
  CHECK_FALSE(said.sunIsMeasured);
  CHECK(said.sunElevation == radians(17.0));
}

TEST_CASE("the sun alone points a level camera, if anything tells how high it stands") {
  CameraSettings truth = landscape();
  truth.azimuth = radians(8.0);
  truth.elevation = radians(12.0);
  truth.roll = 0.0;
  PointingClues clues;
  clues.sun = placeOf(truth, 0.0, radians(17.0));
  CHECK_FALSE(pointLens(truth, clues));
  clues.sceneSunElevation = radians(17.0);
  const PhotoCamera found = pointLens(truth, clues).value();
  CHECK(found.camera.roll == 0.0);
  CHECK(std::abs(found.camera.azimuth - truth.azimuth) < 1e-9);
  CHECK(found.sunElevation == radians(17.0));
}

TEST_CASE("a panorama's middle row is its horizon") {
  CameraSettings panorama;
  panorama.projection = Projection::equirectangular;
  panorama.fieldOfView = 2.0 * kPi;
  panorama.elevation = 0.0;
  panorama.width = 720;
  panorama.height = 360;
  PointingClues clues;
  clues.sun = Vec2(460.0, 150.0);  // half a degree a pixel
  const PhotoCamera found = pointLens(panorama, clues).value();
  CHECK(found.camera.elevation == 0.0);
  CHECK(found.camera.roll == 0.0);
  CHECK(std::abs(found.sunElevation - radians(15.0)) < 1e-9);
  CHECK(std::abs(found.camera.azimuth + radians(50.0)) < 1e-9);
}

}  // namespace parhelion
