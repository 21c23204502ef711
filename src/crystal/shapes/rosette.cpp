// SPDX-License-Identifier: Apache-2.0
#include "crystal/shapes/rosette.h"

#include <cmath>
#include <iterator>
#include <stdexcept>

#include "crystal/mesh/body_union.h"
#include "crystal/shapes/sides.h"
#include "math/portable.h"

namespace parhelion {

namespace {

/// The frame of a bullet whose axis is in the plane of crystal x and z, turned by an azimuth about z: the normal of its
/// face 3 is in the plane of its axis and z.
Mat3 frameOf(double cosZenith, double azimuth) {
  const double c = cosZenith, s = std::sqrt(1.0 - c * c), ca = portable::cos(azimuth), sa = portable::sin(azimuth);
  return {Vec3(ca * c, sa * c, -s), Vec3(-sa, ca, 0.0), Vec3(ca * s, sa * s, c)};
}

/// A bullet along c, its apex so far below the origin that it overlaps others.
std::vector<FacePlane> bulletPlanes(const RosetteSettings& rosette, int firstNumber) {
  const double height = 0.5 * std::sqrt(3.0) / portable::tan(rosette.slope);
  const double tail = height * (1.0 - rosette.overlap);  // where the prism begins
  std::vector<FacePlane> planes{endPlanes(tail + 2.0 * rosette.aspect, 0.0).front()};
  for (const FacePlane& plane : sidePlanes(kRegularSides)) planes.push_back(plane);
  for (FacePlane plane : sidePlanes(kRegularSides, 23, -rosette.slope)) {
    // Through the apex, and exactly so where that is the centre.
    plane.distance = plane.normal.z * -height * rosette.overlap;
    planes.push_back(plane);
  }
  for (FacePlane& plane : planes) plane.number += firstNumber;
  return planes;
}

}  // namespace

std::vector<Mat3> bulletFrames(int bullets) {
  std::vector<Mat3> frames;
  const auto ring = [&](int count, double cosZenith, double firstAzimuth) {
    for (int k = 0; k < count; ++k) frames.push_back(frameOf(cosZenith, firstAzimuth + 2.0 * kPi * k / count));
  };
  const bool hasLower = bullets == 2 || bullets >= 5;
  if (bullets != 3) ring(1, 1.0, 0.0);
  if (bullets == 3 || bullets == 5) ring(3, 0.0, 0.0);
  if (bullets == 4) ring(3, -1.0 / 3.0, 0.0);
  if (bullets == 6 || bullets == 7) ring(bullets - 2, 0.0, 0.0);
  if (bullets == 8) {
    ring(3, 1.0 / 3.0, 0.0);
    ring(3, -1.0 / 3.0, kPi / 3.0);
  }
  if (hasLower) ring(1, -1.0, 0.0);
  return frames;
}

CrystalMesh meshOf(const RosetteSettings& rosette) {
  std::vector<std::vector<FacePlane>> bodies;
  for (const Mat3& frame : bulletFrames(rosette.bullets)) {
    bodies.push_back(bulletPlanes(rosette, 100 * static_cast<int>(bodies.size())));
    for (FacePlane& plane : bodies.back()) plane.normal = frame * plane.normal;
  }
  return unionOf(bodies);
}

}  // namespace parhelion
