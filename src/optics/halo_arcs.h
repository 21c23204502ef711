// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "math/portable.h"
#include "optics/halo_forms.h"

namespace parhelion {

/// The sun and the ice, as the closed forms of halos need them.
struct HaloSky {
  double elevation, index;
  Vec3 toSun;
  double sine, cosine;  // of the sun's elevation

  HaloSky(double sunElevation, double iceIndex);

  /// n^2 - 1
  double excess() const { return (index - 1.0) * (index + 1.0); }

  /// Least turn (rad) by a 60 degree wedge about its edge, of light whose sine of inclination to the wedge's principal
  /// section is given: the least deviation with Bravais' index. None where all light is reflected inside.
  std::optional<double> leastTurn(double sineInclination) const;
};

/// The halos of crystals of one family with faces across c (`ends`) and along it (`sides`), where they have them.
void addPlateHalos(HaloForms& forms, const HaloSky& sky, const HaloMaker& maker);
void addColumnHalos(HaloForms& forms, const HaloSky& sky, const HaloMaker& maker);
void addParryHalos(HaloForms& forms, const HaloSky& sky, const HaloMaker& maker);
void addLowitzHalos(HaloForms& forms, const HaloSky& sky, const HaloMaker& maker);
void addRings(HaloForms& forms, const HaloSky& sky, const HaloMaker& maker);

// What these have in common.

inline double arcsine(double s) { return portable::atan2(s, std::sqrt(std::max(0.0, (1.0 - s) * (1.0 + s)))); }
inline double arccosine(double c) { return portable::atan2(std::sqrt(std::max(0.0, (1.0 - c) * (1.0 + c))), c); }

/// The horizontal direction of a sky azimuth, and the one 90 degrees to its right.
struct Horizontal {
  Vec3 axis, across;
};
Horizontal horizontal(double azimuth);

/// Azimuth (rad) that light going in through a horizontal face and out through a vertical one, or the other way round,
/// is turned by at most: the angle less the refracted one at grazing incidence. Components of light along the
/// horizontal outside, first and last, sorted; their ratio is the refraction's index.
double mostTurn(double smaller, double larger);

/// Adds a halo with its label at a share of its first line, unless it has no lines or its name is there already, from
/// crystals that stand otherwise.
void addCurve(HaloForms& forms, HaloCurve curve, double labelShare = 0.5);
void addPoint(HaloForms& forms, HaloPoint point);

/// Halos that light makes by reflection off upright faces, whatever crystals have them.
void addParhelicCircle(HaloForms& forms, const HaloSky& sky, HaloFamily family);

/// Halos that light makes by reflection off level faces, or faces about level axes.
void addSubsunAndPillar(HaloForms& forms, const HaloSky& sky, HaloFamily family);

}  // namespace parhelion
