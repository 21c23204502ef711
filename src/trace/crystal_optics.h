// SPDX-License-Identifier: Apache-2.0
#pragma once

// What real crystals do beyond Fresnel and Snell; of a single ray, or of the lanes of T. Vector is Vec3, or Triple<T>.

#include "math/exact_sum.h"
#include "math/exponential.h"
#include "math/table_quantile.h"
#include "trace/branch.h"

namespace parhelion {

/// What is not ideal about the crystals of a population, as plain numbers that lanes can run on.
struct CrystalOptics {
  bool absorbs = false, diffracts = false;
  double distortion = 0.0;      // standard deviation of either slope of a face
  TableQuantile slope, fringe;  // of normal numbers; of t in fringeOf()

  bool isIdeal() const { return !absorbs && !diffracts && distortion == 0.0; }
};

/// Those of some distortion (rad).
CrystalOptics crystalOptics(bool absorbs, bool diffracts, double distortion);

/// Light on its way through a crystal that absorbs.
template <class T>
struct Attenuated {
  T left, taken;  // energy
  T path;         // energy-weighted length
};
/// `absorption` per length.
template <class T>
PARHELION_INLINE Attenuated<T> attenuated(const T& energy, const T& absorption, const T& distance) {
  const T depth = absorption * distance, share = expOfMinus(depth);
  // Light below half a unit of the sums is none any more (UnitSum): so chains end that go on for ever.
  constexpr double kLeast = 0.5 / ExactSum::kScale;
  const T beyond = energy * share, left = select(beyond < kLeast, T{}, beyond), taken = energy - left;
  // What is taken over the absorption is the path; where that would cancel, by its series.
  constexpr double kThin = 1e-4;
  const T mean = select(depth < kThin, 1.0 - 0.5 * depth, (1.0 - share) / higher(depth, all<T>(kThin)));
  return {left, taken, energy * distance * mean};
}

/// A unit vector at right angles to another, and the third of both. Duff et al. 2017, "Building an orthonormal basis,
/// revisited".
template <class T, class Vector>
PARHELION_INLINE void acrossOf(const Vector& n, Vector& one, Vector& other) {
  const T sign = select(n.z < 0.0, all<T>(-1.0), all<T>(1.0));
  const T a = -1.0 / (sign + n.z), b = n.x * n.y * a;
  one = {1.0 + sign * n.x * n.x * a, sign * b, -(sign * n.x)};
  other = {b, sign + n.y * n.y * a, -n.y};
}

PARHELION_INLINE Vec3 select(bool which, const Vec3& a, const Vec3& b) { return which ? a : b; }

/// branch() at a face that is tilted by chance (Macke, Mueller & Raschke 1996, J. Atmos. Sci. 53, 2813): its two slopes
/// are normal, for two numbers in (0, 1). Where a tilted face would send light through the face itself, or lies in the
/// dark, it is not tilted.
template <class T, class Vector>
PARHELION_INLINE Branches<T, Vector> branchAtTilted(const Vector& lightDir, const Vector& towardLight,
                                                    const T& cosTheta_i, const RelativeIndexOf<T>& index,
                                                    const T& energy, const T& splitAbove, const T& random,
                                                    const CrystalOptics& optics, const T& u1, const T& u2) {
  Vector one, other;
  acrossOf<T>(towardLight, one, other);
  const T slope1 = optics.distortion * optics.slope.at(u1), slope2 = optics.distortion * optics.slope.at(u2);
  const T perLength = 1.0 / squareRoot(1.0 + slope1 * slope1 + slope2 * slope2);
  const Vector tilted = perLength * (towardLight + slope1 * one + slope2 * other);
  const T cosine = -dot(tilted, lightDir), lit = higher(cosine, T{});
  const auto b = branch(lightDir, tilted, lit, index, energy, splitAbove, random);
  const MaskOf<T> isTilted = (cosine > 0.0) & (dot(b.reflectedDir, towardLight) > 0.0) &
                             ((b.transmitted <= 0.0) | (dot(b.transmittedDir, towardLight) < 0.0));
  return branch(lightDir, select(isTilted, tilted, towardLight), select(isTilted, cosine, cosTheta_i), index, energy,
                splitAbove, random);
}

/// A place in the pattern of light behind a slit, in the units of its first zero, for a number in (0, 1). Its density
/// is (sin(pi x) / pi x)^2. The table is of t = |x| / (1 + |x|).
template <class T>
PARHELION_INLINE T fringeOf(const CrystalOptics& optics, const T& u) {
  const MaskOf<T> isLower = u < 0.5;
  const T t = optics.fringe.at(select(isLower, 2.0 * u, 2.0 * u - 1.0)), x = t / (1.0 - t);
  return select(isLower, -x, x);
}

/// Light of direction `lightDir` (unit) that leaves by a face, as Fraunhofer's pattern of a parallelogram spreads it:
/// that is what the sides `one` and `other` of a rectangle look like along the light. `wave` is the wavelength in the
/// sides' unit; u1 and u2 are numbers in (0, 1).
template <class T, class Vector>
PARHELION_INLINE Vector diffracted(const Vector& lightDir, const Vector& one, const Vector& other, const T& wave,
                                   const CrystalOptics& optics, const T& u1, const T& u2) {
  // Seen edge-on a face has no area; light goes anywhere then.
  constexpr double kEdgeOn = 1e-12;
  const Vector alongOne = cross(other, lightDir), alongOther = cross(lightDir, one);
  const T area = dot(lightDir, cross(one, other)), scale = wave / higher(higher(area, -area), all<T>(kEdgeOn));
  const T by1 = scale * fringeOf(optics, u1), by2 = scale * fringeOf(optics, u2);
  const Vector turned = lightDir + by1 * alongOne + by2 * alongOther;
  return (1.0 / squareRoot(dot(turned, turned))) * turned;
}

}  // namespace parhelion
