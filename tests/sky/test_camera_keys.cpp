// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "sky/tally_info_text.h"
#include "unusual_cameras.h"

using namespace parhelion;
using namespace parhelion::test;

TEST_CASE("every setting of a camera has a key") {
  CameraSettings camera;
  camera.projection = Projection::fisheyeStereographic;
  UnusualKeys unusual(camera, FieldOfViewAxis::vertical);
  visitCameraKeys(unusual);
  // A setting that is new does not compile until it is named here.
  const CameraSettings usual;
  const auto& [projection, azimuth, elevation, roll, axis, fieldOfView, imageCircle, distortion, shift, horizon, width,
               height] = camera;
  CHECK(projection != usual.projection);
  CHECK(azimuth != usual.azimuth);
  CHECK(elevation != usual.elevation);
  CHECK(roll != usual.roll);
  CHECK(axis != usual.fieldOfViewAxis);
  CHECK(fieldOfView != usual.fieldOfView);
  CHECK(imageCircle != usual.imageCircle);
  const auto& [k1, k2, k3] = distortion;
  CHECK((k1 != 0.0 && k2 != 0.0 && k3 != 0.0));
  CHECK((shift.x != 0.0 && shift.y != 0.0));
  CHECK(horizon != usual.horizon);
  CHECK(width != usual.width);
  CHECK(height != usual.height);
}

TEST_CASE("a camera of any projection survives the attributes of a tally's file") {
  for (const CameraSettings& camera : unusualCameras()) {
    CAPTURE(std::string(nameOf(camera.projection)));
    CAPTURE(std::string(keyOf(camera.fieldOfViewAxis).name));
    TallyInfo info;
    info.camera = camera;
    CameraSettings read = infoFromText(textFromInfo(info)).camera;
    read.width = camera.width;  // a picture has its size already
    read.height = camera.height;
    CHECK(read == camera);
  }
}

TEST_CASE("the attributes of a camera keep their names") {
  TallyInfo info;
  info.camera = unusualCameras().front();
  std::vector<std::string> names;
  for (const auto& [key, entry] : textFromInfo(info))
    if (key.find("camera.") != std::string::npos) names.push_back(key);
  std::sort(names.begin(), names.end());
  CHECK(names == std::vector<std::string>{"camera.azimuth", "camera.circle", "camera.elevation", "camera.fov",
                                          "camera.fovAxis", "camera.horizon", "camera.k1", "camera.k2", "camera.k3",
                                          "camera.projection", "camera.roll", "camera.shiftX", "camera.shiftY"});
}

TEST_CASE("a tally's file without one of a camera's attributes, or with a wrong one, is refused") {
  const ExrAttributes whole = textFromInfo({});
  for (const auto& [key, entry] : whole) {
    if (key.find("camera.") == std::string::npos) continue;
    CAPTURE(key);
    ExrAttributes attributes = whole;
    attributes[key] = "round";
    CHECK_THROWS_AS(infoFromText(attributes), std::invalid_argument);
    attributes.erase(key);
    CHECK_THROWS_AS(infoFromText(attributes), std::invalid_argument);
  }
}
