// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <string>

#include "scene/camera_override.h"
#include "scene/describe.h"
#include "scene/view_difference.h"
#include "scene_support.h"
#include "sky/unusual_cameras.h"

using namespace parhelion;
using namespace parhelion::test;

TEST_CASE("a camera of any projection survives being written as an override and read as a scene") {
  for (const CameraSettings& camera : unusualCameras()) {
    const std::string override = cameraOverride(camera);
    CAPTURE(override);
    const Scene scene = sceneOf(kExample, {override});
    CHECK(scene.camera == camera);
    CHECK(cameraOverride(scene.camera) == override);
  }
}

TEST_CASE("an override leaves out what a camera has not") {
  CHECK(cameraOverride(CameraSettings{}) ==
        "camera={ projection = \"fisheye-equal-area\", azimuth = 0, elevation = 90, roll = 0, fov_horizontal = 180, "
        "resolution = [1024, 1024] }");
  CameraSettings camera;
  camera.imageCircle = radians(200.0);
  camera.distortion.k2 = 0.25;
  CHECK(cameraOverride(camera) ==
        "camera={ projection = \"fisheye-equal-area\", azimuth = 0, elevation = 90, roll = 0, fov_horizontal = 180, "
        "image_circle = 200, distortion = [0, 0.25, 0], resolution = [1024, 1024] }");
}

TEST_CASE("two views that differ in one key of the camera are told apart by its name") {
  const Scene one = sceneOf(kExample);
  std::vector<std::string_view> names;
  {
    CameraSettings any;
    UnusualKeys all(any, FieldOfViewAxis::horizontal);
    visitCameraKeys(all);
    names = all.names();
  }
  CHECK(names.size() == 9);
  for (const std::string_view key : names) {
    CAPTURE(std::string(key));
    Scene other = one;
    UnusualKeys change(other.camera, FieldOfViewAxis::horizontal, key);
    visitCameraKeys(change);
    CHECK(!(other.camera == one.camera));
    const auto differ = differencesOfView(one, other);
    if (key == "resolution") {  // the field of view along the height is another, that along the width the same
      CHECK(differ.empty());
      continue;
    }
    REQUIRE(differ.size() == 1);
    const std::string expected = key == "fov_horizontal" ? "field of view" : "camera." + std::string(key);
    CHECK(differ.front().find(expected) != std::string::npos);
  }
}

TEST_CASE("of different lenses only the pointing is compared further") {
  const Scene one = sceneOf(kExample);
  Scene other = one;
  other.sun.elevation = radians(23.0);
  other.camera.projection = Projection::rectilinear;
  other.camera.azimuth = radians(10.0);
  other.camera.distortion.k1 = 0.1;
  CHECK(differencesOfView(one, other) ==
        std::vector<std::string>{"sun.elevation (20 and 23)", "camera.azimuth (0 and 10)", "camera.projection"});
}

TEST_CASE("what belongs to the lens comes after the pointing") {
  const Scene one = sceneOf(kExample);
  Scene other = one;
  other.camera.roll = radians(5.0);
  other.camera.fieldOfView = radians(100.0);
  other.camera.imageCircle = radians(150.0);
  other.camera.distortion.k1 = 0.1;
  CHECK(differencesOfView(one, other) == std::vector<std::string>{"camera.roll (0 and 5)", "the camera's field of view",
                                                                  "camera.distortion",
                                                                  "camera.image_circle (0 and 150)"});
}
