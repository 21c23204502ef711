// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>

#include "halos/experiment.h"

using namespace parhelion;

namespace {

/// Share of the light mirrored by the upper faces of plates under a zenith sun that is seen within `radius` (rad) of
/// the subsun, with its standard error. A tilt by t moves the mirror image by 2 t.
SampleMean withinSubsun(const AngleDistribution& tilt, double radius) {
  const Cloud cloud = cloudUnderPointSun(0.5 * kPi, {prisms(0.02, AxisOrientation{tilt, kFree, kFree})});
  SampleMean share;
  forEachRay(cloud, 300'000, [&](const LightPath& path) {
    if (path.encounters.front().faceNumber != 1) return;
    share.add(angleBetween(path.exits.front().lightDirWorld, Vec3(0, 0, 1)) < radius ? 1.0 : 0.0);
  });
  return share;
}

}  // namespace

TEST_CASE("the two normal tilts of one sigma differ threefold at the centre of the subsun") {
  const double sigma = radians(1.0), tilt = 0.5 * sigma;
  // Per solid angle the tilt is Rayleigh distributed, as a polar angle half normal. Tilted faces intercept less by the
  // cosine of their tilt; that is 1e-4 here.
  const double perSolidAngle = 1.0 - std::exp(-0.5 * 0.25), polar = std::erf(0.5 / std::sqrt(2.0));
  CHECK(polar / perSolidAngle > 3.0);
  const auto check = [&](const AngleDistribution& distribution, double expected) {
    const SampleMean share = withinSubsun(distribution, 2.0 * tilt);
    CHECK(std::abs(share.mean() - expected) < 4.0 * share.standardError() + 1e-4);
  };
  check(Normal{0.0, sigma}, perSolidAngle);
  check(PolarNormal{0.0, sigma}, polar);
}

TEST_CASE("a tilt of sigma per solid angle widens the sun pillar by twice its own spread on the zenith angle") {
  // <t^2> = 2 sigma^2 about the vertical: the mean squared angle between subsun and mirror image is 8 sigma^2.
  const double sigma = radians(1.0);
  const Cloud cloud = cloudUnderPointSun(0.5 * kPi, {prisms(0.02, AxisOrientation{Normal{0.0, sigma}, kFree, kFree})});
  SampleMean squared;
  forEachRay(cloud, 300'000, [&](const LightPath& path) {
    if (path.encounters.front().faceNumber != 1) return;
    const double angle = angleBetween(path.exits.front().lightDirWorld, Vec3(0, 0, 1));
    squared.add(angle * angle);
  });
  // The sphere's curvature and the shadow's cosine take off some sigma^2 = 3e-4 of it.
  CHECK(std::abs(squared.mean() / (8.0 * sigma * sigma) - 1.0) < 4.0 * squared.standardError() / squared.mean() + 1e-3);
}
