// SPDX-License-Identifier: Apache-2.0
#include "scene/scene_halos.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "crystal/population.h"

namespace parhelion {
namespace {

constexpr double kMost = 2.0 / 3.0;  // of the crystals
constexpr double kOriented = radians(15);
constexpr double kFacesLevel = radians(10);  // where the column is free to roll, most are within 20 degrees

// What makes Lowitz plates of plates that tilt far: an edge-to-edge axis that tilts less by this factor than the c
// axis.
constexpr double kSteadier = 0.5;

// Axes that fill less of the quarter circle between zenith and horizon keep to a zenith angle; those in all
// orientations fill 47 degrees, rad.
constexpr double kFree = radians(15);

constexpr int kCrystals = 2000;

double arccosine(double c) { return std::acos(std::clamp(c, 0.0, 1.0)); }

/// What a share of values is below.
double quantile(std::vector<double> values, double share) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

Vec3 vectorOf(const Triple<double>& t) { return {t.x, t.y, t.z}; }

/// How crystals of a population stand, angles in rad.
struct Stance {
  std::vector<double> axisFromVertical, axisFromLevel, faceFromVertical, edgesFromLevel;
};

Stance stanceOf(const OrientationQuantile& orientation, const std::vector<Vec3>& faces) {
  Stance stance;
  for (int i = 0; i < kCrystals; ++i) {
    // Evenly spread points of the unit cube. Roberts 2018.
    const auto share = [i](double step) { return std::fmod(0.5 + step * (i + 1), 1.0); };
    const auto columns =
        orientation.at(share(0.8191725133961645), share(0.6710436067037893), share(0.5497004779019703));
    const Vec3 x = vectorOf(columns.x), y = vectorOf(columns.y), axis = vectorOf(columns.z);
    stance.axisFromVertical.push_back(arccosine(std::abs(axis.z)));
    stance.axisFromLevel.push_back(0.5 * kPi - stance.axisFromVertical.back());
    stance.edgesFromLevel.push_back(0.5 * kPi - arccosine(std::abs(y.z)));
    double nearest = 0.5 * kPi;
    for (const Vec3& n : faces)
      if (isSide(n)) nearest = std::min(nearest, arccosine(std::abs(n.x * x.z + n.y * y.z)));
    stance.faceFromVertical.push_back(nearest);
  }
  return stance;
}

std::optional<HaloFamily> familyOf(const Stance& stance) {
  if (quantile(stance.axisFromVertical, kMost) <= kOriented) return HaloFamily::plates;
  if (quantile(stance.axisFromLevel, kMost) <= kOriented)
    return quantile(stance.faceFromVertical, kMost) <= kFacesLevel ? HaloFamily::parry : HaloFamily::columns;
  const double filled = quantile(stance.axisFromVertical, 5.0 / 6.0) - quantile(stance.axisFromVertical, 1.0 / 6.0);
  if (filled < kFree) return std::nullopt;
  const double edges = quantile(stance.edgesFromLevel, kMost);
  if (edges <= kOriented && edges <= kSteadier * quantile(stance.axisFromVertical, kMost)) return HaloFamily::lowitz;
  return HaloFamily::random;
}

}  // namespace

SceneHalos halosOf(const std::vector<PopulationSettings>& populations) {
  SceneHalos halos;
  for (const PopulationSettings& settings : populations) {
    if (!(settings.weight > 0.0)) continue;
    const Population population(settings);
    std::vector<Vec3> faces;
    for (const Face& face : population.mesh().faces()) faces.push_back(face.normal);
    if (const auto family = familyOf(stanceOf(population.orientation(), faces)))
      halos.makers.push_back({*family, std::move(faces)});
    else
      halos.nameless.push_back(settings.name);
  }
  return halos;
}

}  // namespace parhelion
