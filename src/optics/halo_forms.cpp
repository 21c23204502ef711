// SPDX-License-Identifier: Apache-2.0
#include "optics/halo_forms.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "math/rotation.h"
#include "optics/halo_arcs.h"

namespace parhelion {
namespace {

// A pillar's length (rad, either side of the sun) grows with the crystals' tilts: this is a usual one, of a usual sun.
constexpr double kPillarReach = radians(15);
constexpr double kHighestPillarSun = radians(20);

void addHalosOf(HaloForms& forms, const HaloSky& sky, const HaloMaker& maker) {
  switch (maker.family) {
    case HaloFamily::plates:
      return addPlateHalos(forms, sky, maker);
    case HaloFamily::columns:
      return addColumnHalos(forms, sky, maker);
    case HaloFamily::parry:
      return addParryHalos(forms, sky, maker);
    case HaloFamily::lowitz:
      return addLowitzHalos(forms, sky, maker);
    case HaloFamily::random:
    case HaloFamily::pyramids:
      return addRings(forms, sky, maker);
  }
}

template <class Halo>
bool isThere(const std::vector<Halo>& halos, const std::string& name) {
  return std::any_of(halos.begin(), halos.end(), [&](const Halo& halo) { return halo.name == name; });
}

}  // namespace

HaloSky::HaloSky(double sunElevation, double iceIndex)
    : elevation(sunElevation),
      index(iceIndex),
      toSun(skyDirection(0.0, sunElevation)),
      sine(portable::sin(sunElevation)),
      cosine(portable::cos(sunElevation)) {}

std::optional<double> HaloSky::leastTurn(double sineInclination) const {
  const double cosine2 = (1.0 - sineInclination) * (1.0 + sineInclination);
  const double bravais2 = (index * index - sineInclination * sineInclination) / cosine2;
  if (!(cosine2 > 0.0 && bravais2 <= 4.0)) return std::nullopt;
  return 2.0 * arcsine(0.5 * std::sqrt(bravais2)) - radians(60);
}

Horizontal horizontal(double azimuth) {
  const auto [s, c] = portable::sincos(azimuth);
  return {{c, -s, 0.0}, {-s, -c, 0.0}};
}

double mostTurn(double smaller, double larger) { return 0.5 * kPi - arcsine(smaller / larger); }

void addCurve(HaloForms& forms, HaloCurve curve, double labelShare) {
  if (curve.lines.empty() || isThere(forms.curves, curve.name)) return;
  const SkyLine& line = curve.lines.front();
  curve.labelAt = line[static_cast<std::size_t>(labelShare * static_cast<double>(line.size() - 1))];
  forms.curves.push_back(std::move(curve));
}

void addPoint(HaloForms& forms, HaloPoint point) {
  const bool isKnown = std::any_of(forms.points.begin(), forms.points.end(),
                                   [&](const HaloPoint& p) { return p.name == point.name && p.toSky == point.toSky; });
  if (!isKnown) forms.points.push_back(std::move(point));
}

void addParhelicCircle(HaloForms& forms, const HaloSky& sky, HaloFamily family) {
  const SkyLocus circle = [&](double azimuth) { return skyDirection(azimuth, sky.elevation); };
  addCurve(forms, {"parhelic circle", family, false, followLocus(-kPi, kPi, circle)}, 0.75);
}

void addSubsunAndPillar(HaloForms& forms, const HaloSky& sky, HaloFamily family) {
  addPoint(forms, {"subsun", family, skyDirection(0.0, -sky.elevation)});
  if (std::abs(sky.elevation) >= kHighestPillarSun) return;
  const SkyLocus pillar = [&](double height) { return skyDirection(0.0, sky.elevation + height); };
  addCurve(forms, {"sun pillar", family, false, followLocus(-kPillarReach, kPillarReach, pillar)}, 0.9);
}

HaloForms haloForms(double sunElevation, double index, std::span<const HaloMaker> makers) {
  const HaloSky sky(sunElevation, index);
  std::vector<HaloMaker> inOrder(makers.begin(), makers.end());
  std::stable_sort(inOrder.begin(), inOrder.end(),
                   [](const HaloMaker& a, const HaloMaker& b) { return a.family < b.family; });
  HaloForms forms;
  for (const HaloMaker& maker : inOrder) addHalosOf(forms, sky, maker);
  std::stable_sort(forms.curves.begin(), forms.curves.end(),
                   [](const HaloCurve& a, const HaloCurve& b) { return a.isRare < b.isRare; });
  return forms;
}

HaloForms haloForms(double sunElevation, double index) { return haloForms(sunElevation, index, allHaloMakers()); }

}  // namespace parhelion
