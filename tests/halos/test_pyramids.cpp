// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <vector>

#include "halos/closed_forms.h"
#include "halos/edge_fit.h"
#include "halos/position.h"

using namespace parhelion;

namespace {

struct Halo {
  const char* name;
  double wedge;  // rad
  double edge;   // degrees, at n = 1.31
};

/// The odd-radius halos of {10-11} pyramids, whose faces are at 28 degrees to the c axis.
std::vector<Halo> oddRadiusHalos() {
  // A wedge is half a turn less than the angle between its faces' outward normals. Those of pyramid faces rise by the
  // slope; 120 degrees of azimuth lie between next but one neighbours.
  const auto wedge = [](double cosineOfNormals) { return kPi - std::acos(cosineOfNormals); };
  const double slope = radians(28.0), s = std::sin(slope), c = std::cos(slope);
  return {{"9° ring", wedge(-c), 8.953},                       // 3-16
          {"18° ring", wedge(-0.5 * c * c - s * s), 18.271},   // 13-25
          {"20° ring", wedge(-c * c + s * s), 19.905},         // 13-16
          {"23° ring", wedge(-s), 22.862},                     // 1-23
          {"24° ring", wedge(-0.5 * c), 23.819},               // 3-15
          {"35° ring", wedge(-0.5 * c * c + s * s), 34.929}};  // 13-15
}

}  // namespace

TEST_CASE("pyramidal crystals in random orientation make rings of 9, 18, 20, 23, 24 and 35 degrees") {
  std::vector<Histogram> around;
  std::vector<double> expected;
  for (const Halo& halo : oddRadiusHalos()) {
    expected.push_back(degrees(theory::leastDeviation(halo.wedge, kIndex)));
    CHECK(std::abs(expected.back() - halo.edge) < 0.001);
    around.emplace_back(expected.back() - 0.6, expected.back() + 0.6, 120);
  }

  // A short prism between pyramids of half their full height has all these wedges.
  const PopulationSettings pyramids{"pyramids", 1.0, PyramidSettings{0.4, 0.5, 0.5}, RandomOrientation{}};
  forEachRay(cloudUnderPointSun(0.0, {pyramids}), 2'000'000, [&](const LightPath& path) {
    for (const Exit& exit : path.exits)
      for (Histogram& h : around)
        h.add(degrees(angleBetween(path.incident.lightDirWorld, exit.lightDirWorld)), exit.energy);
  });
  for (std::size_t i = 0; i < around.size(); ++i) {
    CAPTURE(expected[i]);
    const EdgeFit fit = fitEdge(around[i]);
    CHECK(fit.step > 0.0);
    checkPosition(oddRadiusHalos()[i].name, expected[i], fit.position, 0.03);
  }
}
