// SPDX-License-Identifier: Apache-2.0
#include "crystal/symmetry.h"

#include <algorithm>
#include <cmath>

#include "math/overloaded.h"

// With M = diag(1, -1, 1), R(zenith, azimuth, roll) of rotation_columns.h for any angles, also zenith angles beyond the
// poles, and a crystal K, which M leaves as it is:
//   M R(z, a, r) K = R(z, -a, -r) K                  M turns rotations about y as they are, those about z around,
//   R(z, a, r) K = R(z, a, r + 60 degrees) K         K has a sixfold axis,
//   R(z, a, r) K = R(pi - z, a + pi, -r) K           for a K whose ends are alike: the c axis seen from its other end.
// A Lowitz plate is Rz(a) Rx(t) Ry(s), t = pi/2 - zenith of its axis, with any azimuth a. Rz(pi) leaves K as it is and
// turns t and s around, so that
//   M Rz(a) Rx(t) Ry(s) K = Rz(-a) Rx(-t) Ry(s) K = Rz(pi - a) Rx(t) Ry(-s) K.

namespace parhelion {

namespace {

constexpr double kTurn = 2.0 * kPi;

/// Unchanged by angle -> 2 `about` - angle, angles that differ by `period` being the same.
bool isEven(const AngleDistribution& distribution, double about, double period) {
  const double shift = 2.0 * (centreOf(distribution) - about);
  return isFree(distribution, period) || std::abs(std::remainder(shift, period)) < kAngleSlack;
}

/// The same for a zenith angle, signed, about the horizon.
bool isEvenAboutHorizon(const AngleDistribution& zenith) { return isEven(zenith, 0.5 * kPi, kTurn); }

bool isMirrorSymmetric(const RandomOrientation&, bool) { return true; }

bool isMirrorSymmetric(const AxisOrientation& axis, bool endsAlike) {
  constexpr double kSixth = kPi / 3.0;
  if (isEven(axis.azimuth, 0.0, kTurn) && isEven(axis.roll, 0.0, kSixth)) return true;
  // With the ends exchanged the mirror image of (z, a, r) is (pi - z, pi - a, r), whatever the roll.
  return endsAlike && isEvenAboutHorizon(axis.zenith) && isEven(axis.azimuth, 0.5 * kPi, kTurn);
}

bool isMirrorSymmetric(const LowitzOrientation& lowitz, bool endsAlike) {
  const double spinPeriod = endsAlike ? kPi : kTurn;  // half a turn about an edge-to-edge axis exchanges the ends
  return isEvenAboutHorizon(lowitz.axisZenith) || isEven(lowitz.spin, 0.0, spinPeriod);
}

bool keeps(const RandomOrientation&, const Isometry&) { return true; }

/// Unchanged by angle -> angle + shift.
bool isUnchangedBy(const AngleDistribution& distribution, double shift) {
  return std::abs(std::remainder(shift, kTurn)) < kAngleSlack || isFree(distribution, kTurn);
}

bool keeps(const AxisOrientation& axis, const Isometry& isometry) {
  // With k sixths of a turn, F = diag(1, 1, -1), and the images for improper ones reflected by M:
  //   R(z, a, r) Rz(k)      = R(z, a, r + k)
  //   M R(z, a, r) Rz(k) M  = R(z, -a, -r - k)
  //   R(z, a, r) Rz(k) F M  = R(pi - z, a + pi, -r - k)
  //   M R(z, a, r) Rz(k) F  = R(pi - z, -a - pi, r + k)
  // Each also stands for (-z, a + pi, r + pi), the same rotation.
  const double turn = isometry.sixths * kPi / 3.0;
  const bool azimuthTurns = isometry.isProper(), rollTurns = !isometry.flipsY;
  for (const bool otherSide : {false, true}) {
    const double half = otherSide ? kPi : 0.0, azimuthShift = (isometry.flipsZ ? kPi : 0.0) + half;
    const bool zenith =
        isometry.flipsZ ? !otherSide && isEvenAboutHorizon(axis.zenith) : !otherSide || isEven(axis.zenith, 0.0, kTurn);
    const bool azimuth =
        azimuthTurns ? isUnchangedBy(axis.azimuth, azimuthShift) : isEven(axis.azimuth, -0.5 * azimuthShift, kTurn);
    const bool roll =
        rollTurns ? isUnchangedBy(axis.roll, turn + half) : isEven(axis.roll, -0.5 * (turn + half), kTurn);
    if (zenith && azimuth && roll) return true;
  }
  return false;
}

bool keeps(const LowitzOrientation& lowitz, const Isometry& isometry) {
  // Only those that leave the line of crystal +y alone come into question. With t the tilt of +y, s the spin, any
  // azimuth, and M as above:
  //   R(t, s) Ry(pi) = R(t, s + pi)          R(t, s) Rz(pi) = R(-t, -s)        R(t, s) Rx(pi) = R(-t, -s - pi)
  //   M R(t, s) M    = R(-t, s)              M R(t, s) diag(-1, 1, 1) = R(t, -s)
  //   M R(t, s) diag(1, 1, -1) = R(t, -s - pi)          M R(t, s) diag(-1, -1, -1) = R(-t, s + pi)
  if (isometry.sixths % 3 != 0) return false;
  const Vec3 image = isometry(Vec3(1.0, 1.0, 1.0));
  const bool flipsX = image.x < 0.0, flipsY = image.y < 0.0, flipsZ = image.z < 0.0;
  const double shift = flipsZ ? kPi : 0.0;
  const bool tilt = !flipsY || isEvenAboutHorizon(lowitz.axisZenith);
  const bool spin = flipsX == flipsZ ? isUnchangedBy(lowitz.spin, shift) : isEven(lowitz.spin, -0.5 * shift, kTurn);
  return tilt && spin;
}

/// Of crystals of any shape: by the mirrors of a hexagonal prism that are theirs, too.
bool isMirrorSymmetric(const CrystalMesh& mesh, const OrientationSettings& orientation) {
  // All rotations alike make a sky of rings about the sun.
  if (std::holds_alternative<RandomOrientation>(orientation)) return true;
  return std::ranges::any_of(hexagonalGroup(), [&](const Isometry& isometry) {
    return !isometry.isProper() && keepsOrientations(orientation, isometry) && faceImages(mesh, isometry);
  });
}

}  // namespace

bool keepsOrientations(const OrientationSettings& orientation, const Isometry& isometry) {
  return std::visit([&](const auto& own) { return keeps(own, isometry); }, orientation);
}

bool isMirrorSymmetric(const PopulationSettings& population) {
  const bool hexagonal = std::visit([](const auto& shape) { return isHexagonal(shape); }, population.shape);
  if (!hexagonal) return isMirrorSymmetric(meshOf(typicalShape(population.shape)), population.orientation);
  const bool endsAlike = std::visit([](const auto& shape) { return hasEndsAlike(shape); }, population.shape);
  return std::visit([=](const auto& orientation) { return isMirrorSymmetric(orientation, endsAlike); },
                    population.orientation);
}

bool isFullyRandom(const PopulationSettings& population) {
  return std::visit(Overloaded{
                        [](const RandomOrientation&) { return true; },
                        [](const AxisOrientation&) { return false; },
                        [](const LowitzOrientation&) { return false; },
                    },
                    population.orientation);
}

const PopulationSettings* firstWithout(bool (*holds)(const PopulationSettings&),
                                       std::span<const PopulationSettings> populations) {
  const auto found = std::ranges::find_if_not(populations, holds);
  return found == populations.end() ? nullptr : &*found;
}

}  // namespace parhelion
