// SPDX-License-Identifier: Apache-2.0
#include "photo/known_sensors.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

namespace parhelion {
namespace {

constexpr Sensor kFullFrame{36.0, 24.0};
constexpr Sensor kApsH{27.9, 18.6};
constexpr Sensor kApsC{23.5, 15.6};
constexpr Sensor kCanonApsC{22.3, 14.9};
constexpr Sensor kFourThirds{17.3, 13.0};
constexpr Sensor kOneInch{13.2, 8.8};
constexpr Sensor kMediumFormat{43.8, 32.9};

/// Models whose names begin alike: what most of them have, and those that have another sensor. The latter are named by
/// what follows, up to its end or a blank.
struct Family {
  std::string_view make, begin;
  Sensor sensor;
  Sensor other = {};
  std::vector<std::string_view> others = {};
};

/// All families; where several fit, the first counts.
const std::vector<Family>& families() {
  static const std::vector<Family> all = {
      {"CANON", "Canon EOS-1D", kApsH, kFullFrame, {"s", " X", " C"}},
      {"CANON", "Canon EOS ", kCanonApsC, kFullFrame, {"5D", "5DS", "6D", "R", "RP", "R1", "R3", "R5", "R6", "R8"}},
      {"NIKON", "NIKON Z", kFullFrame, kApsC, {" 30", " 50", " fc", "50_2"}},
      {"NIKON",
       "NIKON D",
       kApsC,
       kFullFrame,
       {"3", "3S", "3X", "4", "4S", "5", "6", "600", "610", "700", "750", "780", "800", "800E", "810", "810A", "850",
        "f"}},
      {"NIKON", "NIKON 1 ", kOneInch},
      {"SONY", "ILCE-7", kFullFrame},
      {"SONY", "ILCE-9", kFullFrame},
      {"SONY", "ILCE-1", kFullFrame},
      {"SONY", "ILCE-", kApsC},
      {"SONY", "NEX-", kApsC},
      {"SONY", "SLT-A", kApsC, kFullFrame, {"99", "99V"}},
      {"SONY", "ILCA-", kApsC, kFullFrame, {"99M2"}},
      {"SONY", "DSLR-A", kApsC, kFullFrame, {"850", "900"}},
      {"SONY", "DSC-RX10", kOneInch},
      {"SONY", "DSC-RX1", kFullFrame},
      {"OLYMPUS", "E-", kFourThirds, Sensor{8.8, 6.6}, {"10", "20", "20N", "20P"}},
      {"OM DIGITAL", "OM-", kFourThirds},
      {"PANASONIC", "DMC-G", kFourThirds},
      {"PANASONIC", "DC-G", kFourThirds},
      {"PANASONIC", "DC-S1", kFullFrame},
      {"PANASONIC", "DC-S5", kFullFrame},
      {"FUJIFILM", "GFX", kMediumFormat},
      {"FUJIFILM", "X-S1", kApsC, Sensor{8.8, 6.6}, {""}},
      {"FUJIFILM", "X-", kApsC},
      {"FUJIFILM", "X100", kApsC},
      {"PENTAX", "PENTAX *ist D", kApsC},
      {"PENTAX", "PENTAX K", kApsC, kFullFrame, {"-1"}},
      {"RICOH", "PENTAX K", kApsC, kFullFrame, {"-1"}},
      {"RICOH", "RICOH GR ", kApsC},
  };
  return all;
}

bool isCalled(std::string_view rest, std::string_view name) {
  return rest.starts_with(name) && (rest.size() == name.size() || rest[name.size()] == ' ');
}

std::string inCapitals(std::string text) {
  for (char& c : text)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return text;
}

}  // namespace

std::optional<Sensor> knownSensor(const Exif& exif) {
  const std::string make = inCapitals(exif.make);
  for (const Family& family : families()) {
    if (!make.starts_with(family.make) || !exif.model.starts_with(family.begin)) continue;
    const std::string_view rest = std::string_view(exif.model).substr(family.begin.size());
    const bool other = std::any_of(family.others.begin(), family.others.end(),
                                   [rest](std::string_view name) { return isCalled(rest, name); });
    return other ? family.other : family.sensor;
  }
  return std::nullopt;
}

bool isCommonSensor(double width) {
  constexpr double kLeast = 5.0;
  if (width >= kLeast * (1.0 - kSensorSlack) && width <= kSmallSensor * (1.0 + kSensorSlack)) return true;
  constexpr Sensor kCommon[] = {kFullFrame, kApsC, kCanonApsC, kFourThirds, kOneInch};
  return std::any_of(std::begin(kCommon), std::end(kCommon), [width](const Sensor& sensor) {
    return std::abs(width - sensor.width) <= kSensorSlack * sensor.width;
  });
}

}  // namespace parhelion
