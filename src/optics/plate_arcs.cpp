// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>

#include "math/rotation.h"
#include "optics/face_path.h"
#include "optics/halo_arcs.h"

namespace parhelion {
namespace {

constexpr HaloFamily kFamily = HaloFamily::plates;

SkyLocus levelAt(double elevation) {
  return [elevation](double azimuth) { return skyDirection(azimuth, elevation); };
}

/// Light that goes in at the top and is reflected by a side or more before it leaves by another, as seen from plates
/// turned by an azimuth. It lies in the circle of the circumzenithal arc, of which only what is beyond that arc's
/// `reach` (rad) from the sun's azimuth is taken.
SkyLocus kernArc(const HaloSky& sky, int reflecting, int leaving, double reach) {
  return [sky, reflecting, leaving, reach](double azimuth) -> std::optional<Vec3> {
    const auto side = [&](int k) { return skyDirection(azimuth + k * kPi / 3.0, 0.0); };
    const std::array<Vec3, 3> faces{Vec3(0.0, 0.0, 1.0), side(reflecting), side(leaving)};
    const std::optional<Vec3> seen = seenOver(faces, sky.toSun, sky.index);
    return seen && std::abs(skyPoint(*seen).azimuth) > reach ? seen : std::nullopt;
  };
}

void addCircumzenithalCircle(HaloForms& forms, const HaloSky& sky, bool hasKernArc) {
  // sin h' = sqrt(n^2 - cos^2 h), for light that has met an upper face.
  const double sine2 = sky.excess() + sky.sine * sky.sine;
  if (!(sky.sine >= 0.0 && sine2 <= 1.0)) return;
  const double elevation = arcsine(std::sqrt(sine2));
  const double reach = mostTurn(portable::cos(elevation), sky.cosine);
  addCurve(forms, {"circumzenithal arc", kFamily, false, followLocus(-reach, reach, levelAt(elevation))});
  if (!hasKernArc) return;
  std::vector<SkyLine> kern;
  for (const int leaving : {2, 4, 1, 5})
    for (SkyLine& line : followLocus(0.0, 2.0 * kPi, kernArc(sky, 0, leaving, reach))) kern.push_back(std::move(line));
  addCurve(forms, {"Kern arc", kFamily, true, std::move(kern)});
}

void addCircumhorizontalArc(HaloForms& forms, const HaloSky& sky) {
  // cos h' = sqrt(n^2 - sin^2 h)
  const double cosine2 = sky.excess() + sky.cosine * sky.cosine;
  if (!(sky.sine > 0.0 && cosine2 <= 1.0)) return;
  const double reach = mostTurn(sky.cosine, std::sqrt(cosine2));
  addCurve(forms, {"circumhorizontal arc", kFamily, false,
                   followLocus(-reach, reach, levelAt(arccosine(std::sqrt(cosine2))))});
}

void addSpots(HaloForms& forms, const HaloSky& sky) {
  for (const double side : {-1.0, 1.0}) {
    if (const auto azimuth = sky.leastTurn(sky.sine)) {
      addPoint(forms, {"parhelion", kFamily, skyDirection(side * *azimuth, sky.elevation)});
      addPoint(forms, {"subparhelion", kFamily, skyDirection(side * *azimuth, -sky.elevation)});
    }
    addPoint(forms, {"120° parhelion", kFamily, skyDirection(side * radians(120), sky.elevation)});
  }
}

}  // namespace

void addPlateHalos(HaloForms& forms, const HaloSky& sky, const HaloMaker& maker) {
  if (maker.hasEnds()) addSubsunAndPillar(forms, sky, kFamily);
  if (!maker.hasSides()) return;
  if (maker.hasWedge()) addSpots(forms, sky);
  addParhelicCircle(forms, sky, kFamily);
  if (!maker.hasEnds()) return;
  addCircumzenithalCircle(forms, sky, maker.hasWedge());
  addCircumhorizontalArc(forms, sky);
}

}  // namespace parhelion
