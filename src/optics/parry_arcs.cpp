// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <utility>

#include <glm/geometric.hpp>

#include "math/rotation.h"
#include "optics/face_path.h"
#include "optics/halo_arcs.h"

namespace parhelion {
namespace {

constexpr HaloFamily kFamily = HaloFamily::parry;

/// Prism faces of a Parry column by the elevation of their outward normals, degrees: seen along the axis, those up to
/// 90 are on one side of it and those beyond on the other.
Vec3 sideOf(const Vec3& across, double elevation) {
  const auto [s, c] = portable::sincos(radians(elevation));
  return c * across + s * Vec3(0.0, 0.0, 1.0);
}

/// Light through two prism faces, or off one, as seen from columns whose axis points to an azimuth.
SkyLocus through(const HaloSky& sky, double in, double out) {
  return [sky, in, out](double azimuth) {
    const Vec3 across = horizontal(azimuth).across;
    return seenOver(std::array{sideOf(across, in), sideOf(across, out)}, sky.toSun, sky.index);
  };
}
SkyLocus offEndBetween(const HaloSky& sky, double in, double out) {
  return [sky, in, out](double azimuth) {
    const auto [axis, across] = horizontal(azimuth);
    // The end that light travels toward.
    const Vec3 end = glm::dot(sky.toSun, axis) < 0.0 ? axis : -axis;
    return seenOver(std::array{sideOf(across, in), end, sideOf(across, out)}, sky.toSun, sky.index);
  };
}

SkyLocus off(const HaloSky& sky, double elevation) {
  return [sky, elevation](double azimuth) {
    return seenOver(std::array{sideOf(horizontal(azimuth).across, elevation)}, sky.toSun, sky.index);
  };
}

std::vector<SkyLine> roundTheHorizon(const std::vector<SkyLocus>& loci) {
  std::vector<SkyLine> all;
  for (const SkyLocus& locus : loci)
    for (SkyLine& line : followLocus(0.0, 2.0 * kPi, locus)) all.push_back(std::move(line));
  return all;
}

}  // namespace

void addParryHalos(HaloForms& forms, const HaloSky& sky, const HaloMaker& maker) {
  const auto add = [&](const char* name, bool isRare, const std::vector<SkyLocus>& loci) {
    addCurve(forms, {name, kFamily, isRare, roundTheHorizon(loci)});
  };
  if (maker.hasEnds()) addParhelicCircle(forms, sky, kFamily);
  if (!maker.hasSides()) return;
  addSubsunAndPillar(forms, sky, kFamily);
  if (!maker.hasWedge()) return;
  // In by one prism face and out by another, the outward normals at these elevations.
  add("upper suncave Parry arc", false, {through(sky, 90, -30)});
  add("upper sunvex Parry arc", true, {through(sky, 30, 150)});
  add("lower suncave Parry arc", false, {through(sky, 30, -90)});
  add("lower sunvex Parry arc", true, {through(sky, -30, 210)});
  add("heliac arc", true, {off(sky, 30), off(sky, -30)});
  if (!maker.hasEnds()) return;
  add("Hastings arc", true, {offEndBetween(sky, 90, -30)});
}

}  // namespace parhelion
