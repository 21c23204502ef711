// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <glm/geometric.hpp>

#include "math/rotation.h"
#include "optics/halo_arcs.h"

namespace parhelion {
namespace {

constexpr HaloFamily kFamily = HaloFamily::columns;

// Inclination of light to a prism face's normal, beyond which a regular prism has hardly room for the paths of the
// diffuse arcs, rad.
constexpr double kMostBent = radians(26);

/// Whether light is reflected inside by an end face on its way, which turns its part along the axis around.
enum class End { none, reflects };

/// Light that prism faces turn by an angle (rad) about a column's axis, seen from columns whose axis points to an
/// azimuth.
Vec3 turnedAbout(const Vec3& axis, const Vec3& toSun, double turn, End end) {
  const double along = glm::dot(toSun, axis);
  const auto [s, c] = portable::sincos(turn);
  const Vec3 across = toSun - along * axis;
  return (end == End::reflects ? -along : along) * axis + c * across + s * glm::cross(axis, across);
}

/// Where columns turn light least by two prism faces 60 degrees apart: one place for each azimuth of the axis, above
/// the sun for one `sense` of the turn and below it for the other. Humphreys 1940; Tape 1994.
SkyLocus tangentArc(const HaloSky& sky, double sense, End end) {
  return [sky, sense, end](double azimuth) -> std::optional<Vec3> {
    const Vec3 axis = horizontal(azimuth).axis;
    const std::optional<double> turn = sky.leastTurn(glm::dot(sky.toSun, axis));
    if (!turn) return std::nullopt;
    return turnedAbout(axis, sky.toSun, sense * *turn, end);
  };
}

/// Two of the prism faces it is reflected by turn light by twice the angle between them whatever the column's roll,
/// and leave the ways in and out alike.
SkyLocus twiceReflected(const HaloSky& sky, End end) {
  return [sky, end](double azimuth) -> std::optional<Vec3> {
    return turnedAbout(horizontal(azimuth).axis, sky.toSun, radians(120), end);
  };
}

/// Angle of incidence, seen along the axis, at which light through a prism face is just reflected totally by the next
/// face but one, toward which it is bent. `along` is the sine of light's inclination to the plane across the axis.
std::optional<double> incidenceAtTotalReflection(const HaloSky& sky, double along) {
  const double outside2 = (1.0 - along) * (1.0 + along), inside2 = sky.excess() + outside2;
  const double bent = radians(60) - arccosine(std::sqrt(sky.excess() / inside2));
  const double sine2 = inside2 * portable::sin(bent) * portable::sin(bent);
  if (!(bent <= kMostBent && sine2 <= outside2)) return std::nullopt;
  return arcsine(std::sqrt(sine2 / outside2));
}

/// Light that prism faces reflect an odd number of times leaves in all directions about the axis, as the column rolls,
/// and its circles meet in the anthelion. It is brightest where one of the reflections ceases to be total, by paths
/// like 3-5-1-7 at a turn of `from` + `per` times the incidence there.
SkyLocus diffuseArc(const HaloSky& sky, double from, double per) {
  return [sky, from, per](double azimuth) -> std::optional<Vec3> {
    const Vec3 axis = horizontal(azimuth).axis;
    const std::optional<double> incidence = incidenceAtTotalReflection(sky, glm::dot(sky.toSun, axis));
    if (!incidence) return std::nullopt;
    return turnedAbout(axis, sky.toSun, from + per * *incidence, End::reflects);
  };
}

std::vector<SkyLine> diffuseArcs(const HaloSky& sky) {
  std::vector<SkyLine> arcs = followLocus(0.0, 2.0 * kPi, diffuseArc(sky, radians(60), 2.0));  // 3-5-1-7
  std::vector<SkyLine> others = followLocus(0.0, 2.0 * kPi, diffuseArc(sky, kPi, -2.0));       // 3-5-6-7-1-3
  std::move(others.begin(), others.end(), std::back_inserter(arcs));
  return arcs;
}

void addTangentArcs(HaloForms& forms, const HaloSky& sky) {
  std::vector<SkyLine> upper = followLocus(0.0, kPi, tangentArc(sky, 1.0, End::none));
  std::vector<SkyLine> lower = followLocus(0.0, kPi, tangentArc(sky, -1.0, End::none));
  // Where even an axis in the sun's vertical lets light through, the arcs meet and enclose the ring.
  if (sky.leastTurn(sky.cosine)) {
    upper.insert(upper.end(), lower.begin(), lower.end());
    addCurve(forms, {"circumscribed halo", kFamily, false, std::move(upper)}, 0.25);
    return;
  }
  addCurve(forms, {"upper tangent arc", kFamily, false, std::move(upper)}, 0.15);
  addCurve(forms, {"lower tangent arc", kFamily, false, std::move(lower)}, 0.2);
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
SkyLocus lateralArc(const HaloSky& sky, double excess, double side) {
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

void addLateralArcs(HaloForms& forms, const HaloSky& sky) {
  const auto both = [&](double excess) {
    // Half a turn of the axis is all: its other end is the same column's.
    std::vector<SkyLine> lines = followLocus(-0.5 * kPi, 0.5 * kPi, lateralArc(sky, excess, 1.0));
    for (SkyLine& line : followLocus(-0.5 * kPi, 0.5 * kPi, lateralArc(sky, excess, -1.0)))
      lines.push_back(std::move(line));
    return lines;
  };
  addCurve(forms, {"supralateral arc", kFamily, false, both(-sky.excess())}, 0.2);
  addCurve(forms, {"infralateral arc", kFamily, false, both(sky.excess())}, 0.15);
}

}  // namespace

void addColumnHalos(HaloForms& forms, const HaloSky& sky, const HaloMaker& maker) {
  if (maker.hasEnds()) addParhelicCircle(forms, sky, kFamily);
  if (!maker.hasSides()) return;
  if (maker.hasWedge()) addTangentArcs(forms, sky);
  addSubsunAndPillar(forms, sky, kFamily);
  if (maker.hasWedge())
    addCurve(forms, {"subhelic arc", kFamily, true, followLocus(0.0, 2.0 * kPi, twiceReflected(sky, End::none))}, 0.1);
  if (!maker.hasEnds()) return;
  addLateralArcs(forms, sky);
  addPoint(forms, {"anthelion", kFamily, skyDirection(kPi, sky.elevation)});
  if (!maker.hasWedge()) return;
  addCurve(forms, {"Wegener arc", kFamily, true, followLocus(0.0, kPi, tangentArc(sky, 1.0, End::reflects))}, 0.1);
  addCurve(forms, {"Tricker arc", kFamily, true, followLocus(0.0, 2.0 * kPi, twiceReflected(sky, End::reflects))}, 0.3);
  addCurve(forms, {"diffuse arcs", kFamily, true, diffuseArcs(sky)}, 0.3);
}

}  // namespace parhelion
