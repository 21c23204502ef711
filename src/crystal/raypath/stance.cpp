// SPDX-License-Identifier: Apache-2.0
#include "crystal/raypath/stance.h"

#include <algorithm>
#include <cmath>
#include <vector>

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

// A face counts as parallel to c in spite of rounding.
constexpr double kAlongC = 1e-9;

double arccosine(double c) { return std::acos(std::clamp(c, 0.0, 1.0)); }

/// What a share of values is below.
double quantile(std::vector<double> values, double share) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

Vec3 vectorOf(const Triple<double>& t) { return {t.x, t.y, t.z}; }

/// How crystals of a population stand, angles in rad.
struct Leanings {
  std::vector<double> axisFromVertical, axisFromLevel, faceFromVertical, edgesFromLevel;
};

Leanings leaningsOf(const OrientationQuantile& orientation, const CrystalMesh& mesh) {
  Leanings leanings;
  for (int i = 0; i < kCrystals; ++i) {
    // Evenly spread points of the unit cube. Roberts 2018.
    const auto share = [i](double step) { return std::fmod(0.5 + step * (i + 1), 1.0); };
    const auto columns =
        orientation.at(share(0.8191725133961645), share(0.6710436067037893), share(0.5497004779019703));
    const Vec3 x = vectorOf(columns.x), y = vectorOf(columns.y), axis = vectorOf(columns.z);
    leanings.axisFromVertical.push_back(arccosine(std::abs(axis.z)));
    leanings.axisFromLevel.push_back(0.5 * kPi - leanings.axisFromVertical.back());
    leanings.edgesFromLevel.push_back(0.5 * kPi - arccosine(std::abs(y.z)));
    double nearest = 0.5 * kPi;
    for (const Face& face : mesh.faces())
      if (std::abs(face.normal.z) < kAlongC)
        nearest = std::min(nearest, arccosine(std::abs(face.normal.x * x.z + face.normal.y * y.z)));
    leanings.faceFromVertical.push_back(nearest);
  }
  return leanings;
}

std::optional<Stance> stanceOf(const Leanings& leanings) {
  if (quantile(leanings.axisFromVertical, kMost) <= kOriented) return Stance::plate;
  if (quantile(leanings.axisFromLevel, kMost) <= kOriented)
    return quantile(leanings.faceFromVertical, kMost) <= kFacesLevel ? Stance::parry : Stance::column;
  const double filled = quantile(leanings.axisFromVertical, 5.0 / 6.0) - quantile(leanings.axisFromVertical, 1.0 / 6.0);
  if (filled < kFree) return std::nullopt;
  const double edges = quantile(leanings.edgesFromLevel, kMost);
  if (edges <= kOriented && edges <= kSteadier * quantile(leanings.axisFromVertical, kMost)) return Stance::lowitz;
  return Stance::random;
}

}  // namespace

std::optional<Stance> stanceOf(const Population& population) {
  return stanceOf(leaningsOf(population.orientationQuantile(), population.mesh()));
}

}  // namespace parhelion
