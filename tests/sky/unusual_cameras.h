// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "math/names.h"
#include "sky/camera_keys.h"
#include "sky/projections.h"

namespace parhelion::test {

/// Gives keys of a camera values that are not their defaults, in whole degrees or hundredths: all keys, or the only
/// one of this name.
class UnusualKeys {
 public:
  explicit UnusualKeys(CameraSettings& camera, FieldOfViewAxis axis, std::string_view only = "")
      : camera_(camera), axis_(axis), only_(only) {}

  const std::vector<std::string_view>& names() const { return names_; }

  void projection(const CameraKey&) {}
  void number(const CameraKey& key, InDegrees unit, double CameraSettings::*member) {
    if (wants(key.name)) camera_.*member = radians(std::floor(between(unit.range, 0.3)));
  }
  void number(const CameraKey& key, Unitless unit, double CameraSettings::*member) {
    if (wants(key.name)) camera_.*member = between(unit.range, 0.3);
  }
  void numberOrNone(const CameraKey& key, auto unit, double CameraSettings::*member) {
    if (isFisheye(camera_.projection) && !showsHemispheres(camera_.projection))
      number(key, decltype(unit){{unit.range.lo, 0.5 * unit.range.hi}}, member);
  }
  void numbers(const CameraKey& key, auto /*unit*/, auto member, const auto& parts) {
    const bool isLens = visitProjection(camera_.projection, [](auto facts) { return facts.isAzimuthal; });
    if (!isLens || showsHemispheres(camera_.projection) || !wants(key.name)) return;
    for (std::size_t i = 0; i < parts.size(); ++i) camera_.*member.*parts[i].member = 0.01 * static_cast<double>(i + 1);
  }
  void choice(const CameraKey& key, auto member) {
    if (wants(key.name)) camera_.*member = kMembersOf<std::remove_cvref_t<decltype(camera_.*member)>>.back();
  }
  void fieldOfView(const FieldOfViewAttributes&, InDegrees) {
    if (showsHemispheres(camera_.projection) || !wants(keyOf(axis_).name)) return;
    camera_.fieldOfViewAxis = axis_;
    camera_.fieldOfView = radians(35.0);
  }
  void resolution(const CameraKey& key) {
    if (wants(key.name)) camera_.width = 322, camera_.height = 123;
  }

 private:
  static double between(const Range& range, double share) { return range.lo + share * (range.hi - range.lo); }

  bool wants(std::string_view name) {
    names_.push_back(name);
    return only_.empty() || only_ == name;
  }

  CameraSettings& camera_;
  FieldOfViewAxis axis_;
  std::string_view only_;
  std::vector<std::string_view> names_;
};

/// Cameras of every projection and every axis of the field of view, with no default in any key that they can have.
inline std::vector<CameraSettings> unusualCameras() {
  std::vector<CameraSettings> all;
  for (const Projection projection : kMembersOf<Projection>) {
    const bool hasDiagonal = visitProjection(projection, [](auto facts) { return facts.hasDiagonal; });
    for (const FieldOfViewKey& key : kFieldOfViewKeys) {
      if (key.axis == FieldOfViewAxis::diagonal && !hasDiagonal) continue;
      if (showsHemispheres(projection) && key.axis != FieldOfViewAxis::horizontal) continue;
      CameraSettings& camera = all.emplace_back();
      camera.projection = projection;
      UnusualKeys unusual(camera, key.axis);
      visitCameraKeys(unusual);
    }
  }
  return all;
}

}  // namespace parhelion::test
