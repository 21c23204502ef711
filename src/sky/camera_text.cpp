// SPDX-License-Identifier: Apache-2.0
#include "sky/camera_text.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "math/names.h"
#include "sky/camera_keys.h"

namespace parhelion {
namespace {

std::string cameraAttribute(std::string_view name) { return std::string("camera.").append(name); }

/// Writes the keys of a camera (sky/camera_keys.h) as attributes.
class CameraToText {
 public:
  CameraToText(const CameraSettings& camera, ExrAttributes& plain) : camera_(camera), plain_(plain) {}

  void projection(const CameraKey& key) { put(key.attribute, std::string(nameOf(camera_.projection))); }
  void number(const CameraKey& key, auto /*unit*/, double CameraSettings::*member) {
    put(key.attribute, textOfNumber(camera_.*member + 0.0));
  }
  void numberOrNone(const CameraKey& key, auto unit, double CameraSettings::*member) { number(key, unit, member); }
  void numbers(const CameraKey& key, auto /*unit*/, auto member, const auto& parts) {
    if (key.isNewer && camera_.*member == CameraSettings().*member) return;
    for (const auto& part : parts) put(part.name, textOfNumber(camera_.*member.*part.member + 0.0));
  }
  void choice(const CameraKey& key, auto member) {
    if (key.isNewer && camera_.*member == CameraSettings().*member) return;
    put(key.attribute, std::string(nameOf(camera_.*member)));
  }
  void fieldOfView(const FieldOfViewAttributes& names, InDegrees) {
    put(names.axis, std::string(keyOf(camera_.fieldOfViewAxis).axisName));
    put(names.angle, textOfNumber(camera_.fieldOfView + 0.0));
  }
  void resolution(const CameraKey&) {}

 private:
  void put(std::string_view attribute, std::string entry) { plain_[cameraAttribute(attribute)] = std::move(entry); }

  const CameraSettings& camera_;
  ExrAttributes& plain_;
};

/// Reads them back.
class CameraFromText {
 public:
  CameraFromText(const AttributeReader& attributes, CameraSettings& camera)
      : attributes_(attributes), camera_(camera) {}

  void projection(const CameraKey& key) { camera_.projection = named<Projection>(key.attribute); }
  void number(const CameraKey& key, auto /*unit*/, double CameraSettings::*member) {
    camera_.*member = get(key.attribute);
  }
  void numberOrNone(const CameraKey& key, auto unit, double CameraSettings::*member) { number(key, unit, member); }
  void numbers(const CameraKey& key, auto /*unit*/, auto member, const auto& parts) {
    if (key.isNewer && !has(parts.front().name)) return;
    for (const auto& part : parts) camera_.*member.*part.member = get(part.name);
  }
  template <class Enumeration>
  void choice(const CameraKey& key, Enumeration CameraSettings::*member) {
    if (key.isNewer && !has(key.attribute)) return;
    camera_.*member = named<Enumeration>(key.attribute);
  }
  void fieldOfView(const FieldOfViewAttributes& names, InDegrees) {
    const std::string attribute = cameraAttribute(names.axis);
    const std::string_view axis =
        attributes_.has(attribute) ? std::string_view(attributes_.text(attribute)) : std::string_view();
    const auto key = std::ranges::find(kFieldOfViewKeys, axis, &FieldOfViewKey::axisName);
    if (key == kFieldOfViewKeys.end()) attributes_.reject(attribute, "horizontal, vertical or diagonal");
    camera_.fieldOfViewAxis = key->axis;
    camera_.fieldOfView = get(names.angle);
  }
  void resolution(const CameraKey&) {}

 private:
  bool has(std::string_view attribute) const { return attributes_.has(cameraAttribute(attribute)); }
  double get(std::string_view attribute) const {
    constexpr double kMost = std::numeric_limits<double>::max();  // the camera knows its limits
    return attributes_.number(cameraAttribute(attribute), -kMost, kMost);
  }
  template <class Enumeration>
  Enumeration named(std::string_view name) const {
    const std::string attribute = cameraAttribute(name);
    const auto member =
        attributes_.has(attribute) ? memberNamed<Enumeration>(attributes_.text(attribute)) : std::nullopt;
    if (!member) attributes_.reject(attribute, "one of the names in docs/scene.md");
    return *member;
  }

  const AttributeReader& attributes_;
  CameraSettings& camera_;
};

}  // namespace

ExrAttributes textFromCamera(const CameraSettings& camera) {
  ExrAttributes plain;
  CameraToText writer(camera, plain);
  visitCameraKeys(writer);
  return plain;
}

void readCamera(const AttributeReader& attributes, CameraSettings& camera) {
  CameraFromText reader(attributes, camera);
  visitCameraKeys(reader);
}

}  // namespace parhelion
