// SPDX-License-Identifier: Apache-2.0
#include "cli/view_difference.h"

#include <cmath>
#include <cstdio>

#include "scene/names.h"
#include "sky/camera.h"

namespace parhelion::cli {

namespace {

// Relative: fields of view along different borders that are meant to be the same are rounded by their writers.
constexpr double kSameFocal = 1e-6;

std::string pair(const char* key, double one, double other) {
  char text[120];
  std::snprintf(text, sizeof text, "%s (%.10g and %.10g)", key, one, other);
  return text;
}

}  // namespace

std::vector<std::string> differencesOfView(const Scene& one, const Scene& other) {
  const CameraSettings &a = one.camera, &b = other.camera;
  std::vector<std::string> all;
  const auto compare = [&](const char* key, double first, double second) {
    if (first != second) all.push_back(pair(key, degrees(first), degrees(second)));
  };
  compare("sun.elevation", one.sun.elevation, other.sun.elevation);
  compare("camera.azimuth", a.azimuth, b.azimuth);
  compare("camera.elevation", a.elevation, b.elevation);
  compare("camera.roll", a.roll, b.roll);
  if (a.projection != b.projection) return all.emplace_back("camera.projection"), all;
  const double focal = Camera(a).focalLength() / a.width, otherFocal = Camera(b).focalLength() / b.width;
  if (std::abs(focal - otherFocal) > kSameFocal * focal) all.emplace_back("the camera's field of view");
  if (!(a.distortion == b.distortion)) all.emplace_back("camera.distortion");
  compare("camera.image_circle", a.imageCircle, b.imageCircle);
  return all;
}

}  // namespace parhelion::cli
