// SPDX-License-Identifier: Apache-2.0
#include "scene/camera_override.h"

#include <cstdio>

#include "sky/camera_keys.h"

namespace parhelion {

namespace {

std::string digits(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.15g", value);
  return text;
}

/// Writes the keys of a camera as an inline table has them; what is left out is what a scene leaves out.
class OverrideWriter {
 public:
  explicit OverrideWriter(const CameraSettings& camera) : camera_(camera) {}

  const std::string& text() const { return text_; }

  void projection(const CameraKey& key) { entry(key.name, std::string("\"").append(nameOf(camera_.projection)) + '"'); }
  void number(const CameraKey& key, auto unit, double CameraSettings::*member) {
    entry(key.name, digits(unit.shown(camera_.*member)));
  }
  void numberOrNone(const CameraKey& key, auto unit, double CameraSettings::*member) {
    if (camera_.*member != 0.0) number(key, unit, member);
  }
  template <class Struct>
  void numbers(const CameraKey& key, auto unit, Struct CameraSettings::*member, const auto& parts) {
    const Struct& all = camera_.*member;
    if (all == Struct{}) return;
    std::string list;
    for (const auto& part : parts) list += (list.empty() ? "" : ", ") + digits(unit.shown(all.*part.member));
    entry(key.name, "[" + list + "]");
  }
  void choice(const CameraKey& key, auto member) {
    if (camera_.*member == CameraSettings().*member) return;
    entry(key.name, std::string("\"").append(nameOf(camera_.*member)) + '"');
  }
  void fieldOfView(const FieldOfViewAttributes&, InDegrees unit) {
    if (showsHemispheres(camera_.projection)) return;
    entry(keyOf(camera_.fieldOfViewAxis).name, digits(unit.shown(camera_.fieldOfView)));
  }
  void resolution(const CameraKey& key) {
    entry(key.name, "[" + std::to_string(camera_.width) + ", " + std::to_string(camera_.height) + "]");
  }

 private:
  void entry(std::string_view key, const std::string& value) {
    text_.append(text_.empty() ? "" : ", ").append(key).append(" = ").append(value);
  }

  const CameraSettings& camera_;
  std::string text_;
};

}  // namespace

std::string cameraOverride(const CameraSettings& camera) {
  OverrideWriter writer(camera);
  visitCameraKeys(writer);
  return "camera={ " + writer.text() + " }";
}

}  // namespace parhelion
