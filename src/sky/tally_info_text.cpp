// SPDX-License-Identifier: Apache-2.0
#include "sky/tally_info_text.h"

#include <array>
#include <charconv>
#include <stdexcept>
#include <string_view>

#include "sky/camera.h"

namespace parhelion {
namespace {

constexpr std::string_view kPrefix = "parhelion:";
constexpr std::string_view kFormat = "2";  // of the tally's file; a reader of another format refuses it

constexpr std::array kProjections = {Projection::rectilinear,         Projection::fisheyeEqualArea,
                                     Projection::fisheyeEquidistant,  Projection::fisheyeStereographic,
                                     Projection::fisheyeOrthographic, Projection::equirectangular};

constexpr std::array<std::string_view, 3> kAxisNames = {"horizontal", "vertical", "diagonal"};  // as FieldOfViewAxis

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

CameraSettings cameraFromText(const ExrAttributes& attributes) {
  CameraSettings camera;
  const std::string &projection = value(attributes, "camera.projection"), &axis = value(attributes, "camera.fovAxis");
  bool known = false;
  for (const Projection p : kProjections) {
    if (name(p) == projection) camera.projection = p, known = true;
  }
  if (!known) bad("camera.projection");
  known = false;
  for (std::size_t i = 0; i < kAxisNames.size(); ++i) {
    if (kAxisNames[i] == axis) camera.fieldOfViewAxis = static_cast<FieldOfViewAxis>(i), known = true;
  }
  if (!known) bad("camera.fovAxis");
  camera.azimuth = number<double>(attributes, "camera.azimuth");
  camera.elevation = number<double>(attributes, "camera.elevation");
  camera.roll = number<double>(attributes, "camera.roll");
  camera.fieldOfView = number<double>(attributes, "camera.fov");
  camera.imageCircle = number<double>(attributes, "camera.circle");
  camera.distortion = {number<double>(attributes, "camera.k1"), number<double>(attributes, "camera.k2"),
                       number<double>(attributes, "camera.k3")};
  return camera;
}

}  // namespace

ExrAttributes textFromInfo(const TallyInfo& info) {
  const CameraSettings& camera = info.camera;
  const ExrAttributes plain = {
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
      {"camera.projection", std::string(name(camera.projection))},
      {"camera.azimuth", text(camera.azimuth)},
      {"camera.elevation", text(camera.elevation)},
      {"camera.roll", text(camera.roll)},
      {"camera.fovAxis", std::string(kAxisNames[static_cast<std::size_t>(camera.fieldOfViewAxis)])},
      {"camera.fov", text(camera.fieldOfView)},
      {"camera.circle", text(camera.imageCircle)},
      {"camera.k1", text(camera.distortion.k1)},
      {"camera.k2", text(camera.distortion.k2)},
      {"camera.k3", text(camera.distortion.k3)},
  };
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
  info.camera = cameraFromText(attributes);
  return info;
}

}  // namespace parhelion
