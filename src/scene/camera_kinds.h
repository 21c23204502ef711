// SPDX-License-Identifier: Apache-2.0
#pragma once

// The keys of [camera], which sky/camera_keys.h lists, with the kinds (kinds.h) of their values.

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "scene/kinds.h"
#include "scene/table_kinds.h"
#include "sky/camera_keys.h"

namespace parhelion::kinds {

/// A number of which 0 means that it was left out, so that it has no default.
template <class Kind>
struct NoneIfZero {
  Kind kind;

  bool read(const Value& in, double& out) const { return kind.read(in, out); }
  Json schema() const { return kind.schema(); }
  Json write(double value) const { return value == 0.0 ? Json() : kind.write(value); }
};

template <class Kind>
NoneIfZero(Kind) -> NoneIfZero<Kind>;

/// A struct of numbers as a list of them, or of fewer.
template <class Struct, std::size_t N>
struct NumberList {
  Range range;
  std::array<NumberPart<Struct>, N> parts;

  bool read(const Value& in, Struct& out) const {
    const toml::array* list = in.node.as_array();
    bool valid = list && !list->empty() && list->size() <= N;
    for (std::size_t i = 0; valid && i < list->size(); ++i) {
      const auto number = list->get(i)->value<double>();
      valid = number && range.contains(*number);
      if (valid) out.*parts[i].member = *number;
    }
    if (valid) return true;
    std::string names;
    for (const auto& part : parts) names.append(names.empty() ? "" : ", ").append(part.name);
    return in.mustBe("[" + names + "], numbers " + range.text());
  }
  Json schema() const { return {{"type", "array"}, {"items", numberSchema(range)}, {"minItems", 1}, {"maxItems", N}}; }
  Json write(const Struct& value) const {
    Json list = Json::array();
    for (const auto& part : parts) list.push_back(value.*part.member);
    return list;
  }
};

}  // namespace parhelion::kinds

namespace parhelion {

/// Where a scene's camera counts its azimuth from.
enum class AzimuthFrom { sun, north };

constexpr std::string_view nameOf(AzimuthFrom value) {
  switch (value) {
    case AzimuthFrom::sun:
      return "sun";
    case AzimuthFrom::north:
      return "north";
  }
  return {};
}

/// The [camera] as its keys say it; camera_kind.cpp makes CameraSettings of it.
struct CameraKeys {
  CameraSettings camera;
  std::array<int, 2> resolution{};
  std::array<std::optional<double>, kFieldOfViewKeys.size()> fieldsOfView;  // rad
  AzimuthFrom azimuthFrom = AzimuthFrom::sun;
};

/// Hands each key of a camera to a visitor of scene keys.
template <class Visitor>
class CameraKinds {
 public:
  CameraKinds(Visitor& v, CameraKeys& keys) : v_(v), keys_(keys), camera_(keys.camera) {}

  void projection(const CameraKey& key) {
    v_.key(key.name, kinds::Choice<Projection>{}, camera_.projection, key.documentation);
    camera_ = defaultCamera(camera_.projection);
    keys_.resolution = {camera_.width, camera_.height};
  }
  void number(const CameraKey& key, auto unit, double CameraSettings::*member) {
    v_.key(key.name, kindOf(unit), camera_.*member, key.documentation);
  }
  void numberOrNone(const CameraKey& key, auto unit, double CameraSettings::*member) {
    v_.key(key.name, kinds::NoneIfZero{kindOf(unit)}, camera_.*member, key.documentation);
  }
  template <class Struct, std::size_t N>
  void numbers(const CameraKey& key, Unitless unit, Struct CameraSettings::*member,
               const std::array<NumberPart<Struct>, N>& parts) {
    v_.key(key.name, kinds::NumberList<Struct, N>{unit.range, parts}, camera_.*member, key.documentation);
  }
  template <class Enumeration>
  void choice(const CameraKey& key, Enumeration CameraSettings::*member) {
    v_.key(key.name, kinds::Choice<Enumeration>{}, camera_.*member, key.documentation);
  }
  void fieldOfView(const FieldOfViewAttributes&, InDegrees unit) {
    for (std::size_t i = 0; i < kFieldOfViewKeys.size(); ++i) {
      const FieldOfViewKey& key = kFieldOfViewKeys[i];
      v_.key(key.name, kinds::Optional{kindOf(unit)}, keys_.fieldsOfView[i], key.documentation);
    }
  }
  void resolution(const CameraKey& key) { v_.key(key.name, kinds::Resolution{}, keys_.resolution, key.documentation); }

 private:
  static kinds::Angle kindOf(InDegrees unit) { return {unit.range}; }
  static kinds::Number kindOf(Unitless unit) { return {unit.range}; }

  Visitor& v_;
  CameraKeys& keys_;
  CameraSettings& camera_;
};

template <class Visitor>
void visitKeys(Visitor& v, CameraKeys& c) {
  CameraKinds<Visitor> camera(v, c);
  visitCameraKeys(camera);
  v.key("azimuth_from", kinds::Choice<AzimuthFrom>{}, c.azimuthFrom,
        "Where 'azimuth' counts from, clockwise as seen on a map: the sun, or north, which makes east 90. North needs "
        "the "
        "sun's date or azimuth.");
}

}  // namespace parhelion
