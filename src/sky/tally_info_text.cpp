// SPDX-License-Identifier: Apache-2.0
#include "sky/tally_info_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "math/names.h"
#include "sky/camera_keys.h"

namespace parhelion {
namespace {

constexpr std::string_view kPrefix = "parhelion:";
constexpr std::string_view kFormat = "2";  // of the tally's file; a reader of another format refuses it

template <typename Number>
std::string text(Number value) {
  std::array<char, 32> digits{};
  const auto result = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  return {digits.data(), result.ptr};
}

std::string rangesText(const std::vector<RayRange>& ranges) {
  std::string list;
  for (const RayRange& r : ranges) {
    if (!list.empty()) list += ' ';
    list += text(r.first);
    list += '+';
    list += text(r.count);
  }
  return list;
}

[[noreturn]] void bad(std::string_view name) {
  throw std::invalid_argument("not a tally of Parhelion: attribute " + std::string(kPrefix) + std::string(name) +
                              " is missing or wrong");
}

const std::string& value(const ExrAttributes& attributes, std::string_view name) {
  const auto found = attributes.find(std::string(kPrefix) + std::string(name));
  if (found == attributes.end()) bad(name);
  return found->second;
}

/// Reads a number off the front of `digits`.
template <typename Number>
Number takeNumber(std::string_view& digits, std::string_view name) {
  Number number{};
  const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (error != std::errc{}) bad(name);
  digits.remove_prefix(static_cast<std::size_t>(stop - digits.data()));
  return number;
}

template <typename Number>
Number number(const ExrAttributes& attributes, std::string_view name) {
  std::string_view digits = value(attributes, name);
  const auto result = takeNumber<Number>(digits, name);
  if (!digits.empty()) bad(name);
  return result;
}

std::vector<RayRange> ranges(const ExrAttributes& attributes) {
  std::string_view list = value(attributes, "rays");
  std::vector<RayRange> result;
  while (!list.empty()) {
    RayRange range;
    range.first = takeNumber<std::uint64_t>(list, "rays");
    if (list.empty() || list.front() != '+') bad("rays");
    list.remove_prefix(1);
    range.count = takeNumber<std::uint64_t>(list, "rays");
    if (!list.empty() && list.front() != ' ') bad("rays");
    if (!list.empty()) list.remove_prefix(1);
    result.push_back(range);
  }
  return joined(std::move(result));
}

std::string cameraAttribute(std::string_view name) { return std::string("camera.").append(name); }

/// Writes the keys of a camera (sky/camera_keys.h) as attributes.
class CameraToText {
 public:
  CameraToText(const CameraSettings& camera, ExrAttributes& plain) : camera_(camera), plain_(plain) {}

  void projection(const CameraKey& key) { put(key.attribute, std::string(nameOf(camera_.projection))); }
  void number(const CameraKey& key, auto /*unit*/, double CameraSettings::*member) {
    put(key.attribute, text(camera_.*member));
  }
  void numberOrNone(const CameraKey& key, auto unit, double CameraSettings::*member) { number(key, unit, member); }
  void numbers(const CameraKey& key, auto /*unit*/, auto member, const auto& parts) {
    if (key.isNewer && camera_.*member == CameraSettings().*member) return;
    for (const auto& part : parts) put(part.name, text(camera_.*member.*part.member));
  }
  void choice(const CameraKey& key, auto member) {
    if (key.isNewer && camera_.*member == CameraSettings().*member) return;
    put(key.attribute, std::string(nameOf(camera_.*member)));
  }
  void fieldOfView(const FieldOfViewAttributes& names, InDegrees) {
    put(names.axis, std::string(keyOf(camera_.fieldOfViewAxis).axisName));
    put(names.angle, text(camera_.fieldOfView));
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
  CameraFromText(const ExrAttributes& attributes, CameraSettings& camera) : attributes_(attributes), camera_(camera) {}

  void projection(const CameraKey& key) {
    const std::string attribute = cameraAttribute(key.attribute);
    const auto named = memberNamed<Projection>(value(attributes_, attribute));
    if (!named) bad(attribute);
    camera_.projection = *named;
  }
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
    const std::string attribute = cameraAttribute(key.attribute);
    const auto named = memberNamed<Enumeration>(value(attributes_, attribute));
    if (!named) bad(attribute);
    camera_.*member = *named;
  }
  void fieldOfView(const FieldOfViewAttributes& names, InDegrees) {
    const std::string attribute = cameraAttribute(names.axis);
    const std::string& axis = value(attributes_, attribute);
    const auto key = std::ranges::find(kFieldOfViewKeys, std::string_view(axis), &FieldOfViewKey::axisName);
    if (key == kFieldOfViewKeys.end()) bad(attribute);
    camera_.fieldOfViewAxis = key->axis;
    camera_.fieldOfView = get(names.angle);
  }
  void resolution(const CameraKey&) {}

 private:
  bool has(std::string_view attribute) const {
    return attributes_.contains(std::string(kPrefix) + cameraAttribute(attribute));
  }
  double get(std::string_view attribute) { return parhelion::number<double>(attributes_, cameraAttribute(attribute)); }

  const ExrAttributes& attributes_;
  CameraSettings& camera_;
};

}  // namespace

ExrAttributes textFromInfo(const TallyInfo& info) {
  ExrAttributes plain = {
      {"tally", std::string(kFormat)},
      {"version", info.version},
      {"scene", info.scene},
      {"seed", text(info.seed)},
      {"rays", rangesText(info.rays)},
      {"intercepted", text(info.intercepted)},
      {"undeviated", text(info.undeviated)},
      {"white.X", text(info.white.x)},
      {"white.Y", text(info.white.y)},
      {"white.Z", text(info.white.z)},
      {"sun.elevation", text(info.sunElevation)},
      {"sun.diameter", text(info.sunDiameter)},
  };
  CameraToText camera(info.camera, plain);
  visitCameraKeys(camera);
  ExrAttributes attributes = {{"software", "Parhelion " + info.version}};
  for (const auto& [key, entry] : plain) attributes[std::string(kPrefix) + key] = entry;
  return attributes;
}

TallyInfo infoFromText(const ExrAttributes& attributes) {
  if (value(attributes, "tally") != kFormat) bad("tally");
  TallyInfo info;
  info.version = value(attributes, "version");
  info.scene = value(attributes, "scene");
  info.seed = number<std::uint64_t>(attributes, "seed");
  info.rays = ranges(attributes);
  info.intercepted = number<std::int64_t>(attributes, "intercepted");
  info.undeviated = number<std::int64_t>(attributes, "undeviated");
  info.white = {number<double>(attributes, "white.X"), number<double>(attributes, "white.Y"),
                number<double>(attributes, "white.Z")};
  info.sunElevation = number<double>(attributes, "sun.elevation");
  info.sunDiameter = number<double>(attributes, "sun.diameter");
  CameraFromText camera(attributes, info.camera);
  visitCameraKeys(camera);
  return info;
}

}  // namespace parhelion
