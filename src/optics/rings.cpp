// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <glm/geometric.hpp>

#include "optics/halo_arcs.h"

namespace parhelion {
namespace {

// Wedges that differ by less make one ring, and thinner ones none, rad.
constexpr double kSameWedge = radians(0.05);

// Where most rings are free of other lines: a share of the way round from above, clockwise.
constexpr double kLabelShare = 0.62;

struct Wedge {
  double angle;   // rad
  bool isPrisms;  // between faces along or across the c axis
};

std::vector<Wedge> wedgesOf(const std::vector<Vec3>& faces) {
  const auto isPrisms = [](const Vec3& normal) { return isEnd(normal) || isSide(normal); };
  std::vector<Wedge> wedges;
  for (std::size_t i = 0; i < faces.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) {
      // The cosine of the angle between the outward normals of a wedge's faces is that of the wedge but for its sign.
      const Wedge wedge{arccosine(-glm::dot(faces[i], faces[k])), isPrisms(faces[i]) && isPrisms(faces[k])};
      const auto same = std::find_if(wedges.begin(), wedges.end(),
                                     [&](const Wedge& w) { return std::abs(w.angle - wedge.angle) < kSameWedge; });
      if (same == wedges.end())
        wedges.push_back(wedge);
      else
        same->isPrisms = same->isPrisms || wedge.isPrisms;
    }
  std::sort(wedges.begin(), wedges.end(), [](const Wedge& a, const Wedge& b) { return a.angle < b.angle; });
  return wedges;
}

bool passes(double wedge, double index) { return wedge > kSameWedge && index * portable::sin(0.5 * wedge) <= 1.0; }

}  // namespace

double leastDeviation(double wedge, double index) { return 2.0 * arcsine(index * portable::sin(0.5 * wedge)) - wedge; }

void addRings(HaloForms& forms, const HaloSky& sky, const HaloMaker& maker) {
  for (const Wedge& wedge : wedgesOf(maker.faces)) {
    if (!passes(wedge.angle, sky.index)) continue;
    const double radius = leastDeviation(wedge.angle, sky.index);
    addCurve(forms,
             {std::to_string(std::lround(degrees(radius))) + "° halo",
              wedge.isPrisms ? HaloFamily::random : HaloFamily::pyramids,
              false,
              {circleAbout(sky.toSun, radius)}},
             kLabelShare);
  }
}

}  // namespace parhelion
