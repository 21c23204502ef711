// SPDX-License-Identifier: Apache-2.0
#include "scene/view_difference.h"

#include <cmath>
#include <cstdio>

#include "sky/camera.h"
#include "sky/camera_keys.h"

namespace parhelion {

namespace {

// Relative: fields of view along different borders that are meant to be the same are rounded by their writers.
constexpr double kSameFocal = 1e-6;

/// What differs, if it does: "sun.elevation (20 and 23)".
void compare(std::vector<std::string>& all, const std::string& key, double one, double other, auto unit) {
  if (one == other) return;
  char values[80];
  std::snprintf(values, sizeof values, " (%.10g and %.10g)", unit.shown(one), unit.shown(other));
  all.push_back(key + values);
}

std::string cameraKey(const CameraKey& key) { return std::string("camera.").append(key.name); }

/// Compares two cameras key by key. Of different projections nothing that belongs to the lens is compared.
class CameraComparison {
 public:
  CameraComparison(const CameraSettings& one, const CameraSettings& other, std::vector<std::string>& all)
      : one_(one), other_(other), sameProjection_(one.projection == other.projection), all_(all) {}

  /// To be called after all keys have been visited: what belongs to the lens comes last.
  void finish() {
    all_.insert(all_.end(), lens_.begin(), lens_.end());
    all_.insert(all_.end(), reach_.begin(), reach_.end());
  }

  void projection(const CameraKey& key) {
    if (!sameProjection_) lens_.push_back(cameraKey(key));
  }
  void number(const CameraKey& key, auto unit, double CameraSettings::*member) {
    compare(all_, cameraKey(key), one_.*member, other_.*member, unit);
  }
  void numberOrNone(const CameraKey& key, auto unit, double CameraSettings::*member) {
    if (sameProjection_) compare(reach_, cameraKey(key), one_.*member, other_.*member, unit);
  }
  void numbers(const CameraKey& key, auto /*unit*/, auto member, const auto& /*parts*/) {
    if (sameProjection_ && !(one_.*member == other_.*member)) lens_.push_back(cameraKey(key));
  }
  void choice(const CameraKey& key, auto member) {
    if (one_.*member != other_.*member) reach_.push_back(cameraKey(key));
  }
  void fieldOfView(const FieldOfViewAttributes&, InDegrees) {
    if (!sameProjection_ || showsHemispheres(one_.projection)) return;
    const double focal = Camera(one_).focalLength() / one_.width;
    const double otherFocal = Camera(other_).focalLength() / other_.width;
    if (std::abs(focal - otherFocal) > kSameFocal * focal) lens_.emplace_back("the camera's field of view");
  }
  void resolution(const CameraKey&) {}

 private:
  const CameraSettings &one_, &other_;
  bool sameProjection_;
  std::vector<std::string>& all_;
  std::vector<std::string> lens_, reach_;
};

}  // namespace

std::vector<std::string> differencesOfView(const Scene& one, const Scene& other) {
  std::vector<std::string> all;
  compare(all, "sun.elevation", one.sun.elevation, other.sun.elevation, InDegrees{});
  CameraComparison cameras(one.camera, other.camera, all);
  visitCameraKeys(cameras);
  cameras.finish();
  return all;
}

}  // namespace parhelion
