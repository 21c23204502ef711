// SPDX-License-Identifier: Apache-2.0
#include "scene/camera_override.h"

#include <cstdio>

#include "scene/names.h"

namespace parhelion {

namespace {

std::string digits(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.15g", value);
  return text;
}

std::string_view keyOf(FieldOfViewAxis axis) {
  switch (axis) {
    case FieldOfViewAxis::horizontal:
      return "fov_horizontal";
    case FieldOfViewAxis::vertical:
      return "fov_vertical";
    case FieldOfViewAxis::diagonal:
      break;
  }
  return "fov_diagonal";
}

}  // namespace

std::string cameraOverride(const CameraSettings& camera) {
  const auto entry = [](std::string_view key, double angle) {
    return std::string(", ").append(key) + " = " + digits(degrees(angle));
  };
  std::string text = "camera={ projection = \"" + std::string(nameOf(camera.projection)) + "\"";
  text += entry("azimuth", camera.azimuth) + entry("elevation", camera.elevation) + entry("roll", camera.roll);
  text += entry(keyOf(camera.fieldOfViewAxis), camera.fieldOfView);
  if (camera.imageCircle > 0.0) text += entry("image_circle", camera.imageCircle);
  if (const Distortion& d = camera.distortion; !d.none())
    text += ", distortion = [" + digits(d.k1) + ", " + digits(d.k2) + ", " + digits(d.k3) + "]";
  return text + ", resolution = [" + std::to_string(camera.width) + ", " + std::to_string(camera.height) + "] }";
}

}  // namespace parhelion
