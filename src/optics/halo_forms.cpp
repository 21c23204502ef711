// SPDX-License-Identifier: Apache-2.0
#include "optics/halo_forms.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>

#include "math/portable.h"
#include "math/rotation.h"
#include "optics/sky_line.h"

namespace parhelion {
namespace {

using Line = SkyLine;
using Locus = SkyLocus;

// A pillar's length (rad, either side of the sun) grows with the crystals' tilts: this is a usual one, of a usual sun.
constexpr double kPillarReach = radians(15);
constexpr double kHighestPillarSun = radians(20);

constexpr double kPyramidSlope = radians(28);  // of {10-11} faces to the c axis

double arcsine(double s) { return portable::atan2(s, std::sqrt(std::max(0.0, (1.0 - s) * (1.0 + s)))); }
double arccosine(double c) { return portable::atan2(std::sqrt(std::max(0.0, (1.0 - c) * (1.0 + c))), c); }

/// The horizontal direction of a sky azimuth, and the one 90 degrees to its right.
struct Horizontal {
  Vec3 axis, across;
};
Horizontal horizontal(double azimuth) {
  const auto [s, c] = portable::sincos(azimuth);
  return {{c, -s, 0.0}, {-s, -c, 0.0}};
}

/// What is common to the halos of one sun.
struct Sky {
  double elevation, index;
  Vec3 toSun;
  double sine, cosine;  // of the sun's elevation

  Sky(double sunElevation, double iceIndex)
      : elevation(sunElevation),
        index(iceIndex),
        toSun(skyDirection(0.0, sunElevation)),
        sine(portable::sin(sunElevation)),
        cosine(portable::cos(sunElevation)) {}

  /// n^2 - 1
  double excess() const { return (index - 1.0) * (index + 1.0); }

  /// Least turn (rad) by a 60 degree wedge about its edge, of light whose sine of inclination to the wedge's principal
  /// section is given: the least deviation with Bravais' index. None where all light is reflected inside.
  std::optional<double> leastTurn(double sineInclination) const {
    const double cosine2 = (1.0 - sineInclination) * (1.0 + sineInclination);
    const double bravais2 = (index * index - sineInclination * sineInclination) / cosine2;
    if (!(cosine2 > 0.0 && bravais2 <= 4.0)) return std::nullopt;
    return 2.0 * arcsine(0.5 * std::sqrt(bravais2)) - radians(60);
  }
};

/// Azimuth (rad) that light going in through a plate's horizontal face and out through a vertical one, or the other way
/// round, is turned by at most: the angle less the refracted one at grazing incidence. Components of light along the
/// horizontal outside, first and last, sorted; their ratio is the refraction's index.
double mostTurn(double smaller, double larger) { return 0.5 * kPi - arcsine(smaller / larger); }

void addCurve(HaloForms& forms, std::string name, std::vector<Line> lines, double labelShare = 0.5) {
  if (lines.empty()) return;
  const Line& line = lines.front();
  const auto at = static_cast<std::size_t>(labelShare * static_cast<double>(line.size() - 1));
  const Vec3 label = line[at];
  forms.curves.push_back({std::move(name), std::move(lines), label});
}

Line ring(const Vec3& toSun, double wedge, double index) { return circleAbout(toSun, leastDeviation(wedge, index)); }

bool passes(double wedge, double index) { return index * portable::sin(0.5 * wedge) <= 1.0; }

void addPlateArcs(HaloForms& forms, const Sky& sky) {
  const double c = sky.cosine, s = sky.sine;
  const auto arc = [](double elevation, double reach) {
    return followLocus(-reach, reach, [elevation](double azimuth) { return skyDirection(azimuth, elevation); });
  };
  // sin h' = sqrt(n^2 - cos^2 h), for light that has met an upper face.
  const double sine2 = sky.excess() + s * s;
  if (s >= 0.0 && sine2 <= 1.0) {
    const double elevation = arcsine(std::sqrt(sine2));
    addCurve(forms, "circumzenithal arc", arc(elevation, mostTurn(portable::cos(elevation), c)));
  }
  // cos h' = sqrt(n^2 - sin^2 h)
  const double cosine2 = sky.excess() + c * c;
  if (s > 0.0 && cosine2 <= 1.0)
    addCurve(forms, "circumhorizontal arc", arc(arccosine(std::sqrt(cosine2)), mostTurn(c, std::sqrt(cosine2))));
}

void addPlateSpots(HaloForms& forms, const Sky& sky) {
  const double h = sky.elevation;
  for (const double side : {-1.0, 1.0}) {
    if (const auto azimuth = sky.leastTurn(sky.sine)) {
      forms.points.push_back({"parhelion", skyDirection(side * *azimuth, h)});
      forms.points.push_back({"subparhelion", skyDirection(side * *azimuth, -h)});
    }
    forms.points.push_back({"120° parhelion", skyDirection(side * radians(120), h)});
  }
  forms.points.push_back({"anthelion", skyDirection(kPi, h)});
  forms.points.push_back({"subsun", skyDirection(0.0, -h)});
}

/// Where columns with a horizontal axis turn light least by their prism faces: one place for each azimuth of the axis,
/// above the sun for one `sense` of the turn and below it for the other. Humphreys 1940; Tape 1994.
Locus tangentArc(const Sky& sky, double sense) {
  return [sky, sense](double azimuth) -> std::optional<Vec3> {
    const Vec3 axis = horizontal(azimuth).axis;
    const double along = glm::dot(sky.toSun, axis);
    const std::optional<double> turn = sky.leastTurn(along);
    if (!turn) return std::nullopt;
    const auto [s, c] = portable::sincos(sense * *turn);
    const Vec3 across = sky.toSun - along * axis;
    return along * axis + c * across + s * glm::cross(axis, across);
  };
}

void addTangentArcs(HaloForms& forms, const Sky& sky) {
  std::vector<Line> upper = followLocus(0.0, kPi, tangentArc(sky, 1.0));
  std::vector<Line> lower = followLocus(0.0, kPi, tangentArc(sky, -1.0));
  // Where even an axis in the sun's vertical lets light through, the arcs meet and enclose the ring.
  if (sky.leastTurn(sky.cosine)) {
    upper.insert(upper.end(), lower.begin(), lower.end());
    addCurve(forms, "circumscribed halo", std::move(upper), 0.25);
    return;
  }
  addCurve(forms, "upper tangent arc", std::move(upper), 0.15);
  addCurve(forms, "lower tangent arc", std::move(lower), 0.2);
}

/// Whether a face along a column's axis can turn light that much about it. Seen along the axis, refraction at such a
/// face goes between circles of the two radii: at most from grazing incidence.
bool reaches(const Vec2& before, const Vec2& after) {
  const double a = glm::length(before), b = glm::length(after);
  const double cross = before.x * after.y - before.y * after.x;
  const double turn = std::abs(portable::atan2(cross, glm::dot(before, after)));
  return turn <= mostTurn(std::min(a, b), std::max(a, b));
}

/// Light through a column's 90 degree wedges is seen on a circle about the axis, x.e = w(b) with b = s.e the sun's
/// place along the axis e: w^2 = b^2 + n^2 - 1 for light that goes in through an end (infralateral), b^2 - (n^2 - 1)
/// out through it (supralateral). The halo's edge is the envelope of these circles as e goes round the horizon: x.e' =
/// w' too, the dash for the derivative by azimuth. `excess` is n^2 - 1 with the sign for w^2, `side` the sign of x's z.
Locus lateralArc(const Sky& sky, double excess, double side) {
  return [sky, excess, side](double azimuth) -> std::optional<Vec3> {
    const auto [axis, across] = horizontal(azimuth);
    const double b = glm::dot(sky.toSun, axis), db = glm::dot(sky.toSun, across);
    const double w2 = b * b + excess;
    if (!(w2 > 0.0)) return std::nullopt;
    const double w = std::copysign(std::sqrt(w2), b), dw = b * db / w;
    const double z2 = 1.0 - w2 - dw * dw;
    if (!(z2 >= 0.0)) return std::nullopt;
    const double z = side * std::sqrt(z2);
    if (!reaches({db, sky.sine}, {dw, z})) return std::nullopt;
    return w * axis + dw * across + z * Vec3(0.0, 0.0, 1.0);
  };
}

void addLateralArcs(HaloForms& forms, const Sky& sky) {
  const auto both = [&](double excess) {
    // Half a turn of the axis is all: its other end is the same column's.
    std::vector<Line> lines = followLocus(-0.5 * kPi, 0.5 * kPi, lateralArc(sky, excess, 1.0));
    for (Line& line : followLocus(-0.5 * kPi, 0.5 * kPi, lateralArc(sky, excess, -1.0)))
      lines.push_back(std::move(line));
    return lines;
  };
  addCurve(forms, "supralateral arc", both(-sky.excess()), 0.2);
  addCurve(forms, "infralateral arc", both(sky.excess()), 0.15);
}

/// The way toward the sky of light that has gone through two faces with these outward normals, traced backwards.
std::optional<Vec3> throughFaces(const Vec3& toSun, const Vec3& in, const Vec3& out, double index) {
  const double cosineIn = glm::dot(toSun, in);
  if (!(cosineIn > 0.0)) return std::nullopt;
  const Vec3 inside = toSun + (std::sqrt(cosineIn * cosineIn + (index - 1.0) * (index + 1.0)) - cosineIn) * in;
  const double cosineOut = -glm::dot(inside, out);
  const double cosine2 = cosineOut * cosineOut - (index - 1.0) * (index + 1.0);
  if (!(cosineOut > 0.0 && cosine2 >= 0.0)) return std::nullopt;
  return inside + (cosineOut - std::sqrt(cosine2)) * out;
}

/// The suncave Parry arc: in through a column's horizontal upper face, out through the one that makes a wedge of 60
/// degrees with it.
Locus parryArc(const Sky& sky) {
  return [sky](double azimuth) {
    const Vec3 up(0.0, 0.0, 1.0), slope = horizontal(azimuth).axis;
    return throughFaces(sky.toSun, up, 0.5 * std::sqrt(3.0) * slope - 0.5 * up, sky.index);
  };
}

}  // namespace

double leastDeviation(double wedge, double index) { return 2.0 * arcsine(index * portable::sin(0.5 * wedge)) - wedge; }

HaloForms haloForms(double sunElevation, double index) {
  const Sky sky(sunElevation, index);
  HaloForms forms;
  addCurve(forms, "22° halo", {ring(sky.toSun, radians(60), index)}, 0.62);
  if (passes(radians(90), index)) addCurve(forms, "46° halo", {ring(sky.toSun, radians(90), index)}, 0.62);
  addTangentArcs(forms, sky);
  addCurve(forms, "Parry arc", followLocus(0.0, 2.0 * kPi, parryArc(sky)));
  addLateralArcs(forms, sky);
  addPlateArcs(forms, sky);
  addCurve(forms, "parhelic circle",
           followLocus(-kPi, kPi, [&](double azimuth) { return skyDirection(azimuth, sunElevation); }), 0.75);
  if (std::abs(sunElevation) < kHighestPillarSun)
    addCurve(forms, "sun pillar",
             followLocus(-kPillarReach, kPillarReach,
                         [&](double height) { return skyDirection(0.0, sunElevation + height); }),
             0.9);
  addPlateSpots(forms, sky);
  return forms;
}

std::vector<HaloCurve> pyramidRings(double sunElevation, double index) {
  // The cosine of the angle between the outward normals of a wedge's faces is that of the wedge but for its sign.
  const double c = portable::cos(kPyramidSlope), s = portable::sin(kPyramidSlope);
  const auto wedge = [](double cosineOfNormals) { return arccosine(-cosineOfNormals); };
  const struct {
    const char* name;
    double wedge;
  } rings[] = {
      {"9° halo", wedge(-c)},                     // faces 3-16
      {"18° halo", wedge(-0.5 * c * c - s * s)},  // 13-25
      {"20° halo", wedge(s * s - c * c)},         // 13-16
      {"23° halo", wedge(-s)},                    // 1-23
      {"24° halo", wedge(-0.5 * c)},              // 3-15
      {"35° halo", wedge(s * s - 0.5 * c * c)},   // 13-15
  };
  HaloForms forms;
  const Vec3 toSun = skyDirection(0.0, sunElevation);
  for (const auto& r : rings)
    if (passes(r.wedge, index)) addCurve(forms, r.name, {ring(toSun, r.wedge, index)}, 0.62);
  return std::move(forms.curves);
}

}  // namespace parhelion
