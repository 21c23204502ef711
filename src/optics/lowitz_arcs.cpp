// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include "math/rotation.h"
#include "optics/caustic.h"
#include "optics/face_path.h"
#include "optics/halo_arcs.h"

namespace parhelion {
namespace {

constexpr AngleSteps kHalfTurn{0.0, kPi, 180};
constexpr double kSameWedge = 1e-6;  // of the cosine of the angle between two normals

/// Light through two faces of plates that spin about a level axis, their +y, seen as azimuth and spin go round.
AnglesToSky throughSpinning(const HaloSky& sky, const Vec3& in, const Vec3& out) {
  return [sky, in, out](double azimuth, double spin) {
    const Mat3 crystalToWorld = rotationZ(azimuth) * rotationY(spin);
    return seenOver(std::array{crystalToWorld * in, crystalToWorld * out}, sky.toSun, sky.index);
  };
}

}  // namespace

void addLowitzHalos(HaloForms& forms, const HaloSky& sky, const HaloMaker& maker) {
  std::vector<SkyLine> lines;
  for (const Vec3& in : maker.faces)
    for (const Vec3& out : maker.faces) {
      if (!isSide(in) || !isSide(out) || std::abs(glm::dot(in, out) + 0.5) > kSameWedge) continue;
      // Half a turn about +y or about c brings a plate back to itself with its faces exchanged, and all of them are
      // asked. What is left and right of the sun is alike.
      if (in.y + 2.0 * out.y < 0.0) continue;
      for (SkyLine& line : foldsOf(throughSpinning(sky, in, out), kHalfTurn, kHalfTurn)) {
        lines.push_back(line);
        for (Vec3& toSky : line) toSky.y = -toSky.y;
        lines.push_back(std::move(line));
      }
    }
  // The name stands at the longest.
  std::stable_sort(lines.begin(), lines.end(), [](const SkyLine& a, const SkyLine& b) { return a.size() > b.size(); });
  addCurve(forms, {"Lowitz arc", HaloFamily::lowitz, false, std::move(lines)});
}

}  // namespace parhelion
