// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "beam/prism_group.h"
#include "math/arctangent.h"
#include "math/lanes.h"
#include "optics/interface.h"

namespace parhelion {

/// Faces of a prism by place: 0 ... 5 are face numbers 3 ... 8, 6 and 7 the ends, 1 and 2.
inline constexpr int kPrismFaces = 8, kUpperEnd = 6, kLowerEnd = 7;
constexpr int numberOfPrismFace(int face) { return face < kUpperEnd ? 3 + face : face - 5; }
constexpr int oppositeFace(int face) { return face < kUpperEnd ? (face + 3) % 6 : 13 - face; }

/// Light that entered by one face, was reflected as one element of the group of reflections, and meets another face.
/// All of it leaves in one direction.
struct PrismClass {
  int entry, element, exit;

  bool operator==(const PrismClass&) const = default;
};

/// What becomes of parallel light in a prism that stands still: exact but for what is cut off.
struct PrismLight {
  /// Of each face, shadow (area times cosine, crystal units squared; 0 in the dark) and reflectance outside.
  std::array<double, kPrismFaces> shadow, reflectance;

  /// Light that meets face `exit` from inside as `element`, over the light that went in through `entry`: each time it
  /// does. What leaves there is its transmittance times as much.
  using Arrivals = std::array<std::array<double, kPrismFaces>, kPrismElements>;
  std::array<Arrivals, kPrismFaces> arrived;

  /// Of each entry: light that was given up, over what went in.
  std::array<double, kPrismFaces> cutOff;

  /// Light that leaves at internal encounter k, at [k - 1], in the units of shadows; and the energy-weighted way inside
  /// (crystal units) of all light, in those of volume. Only where they are asked for.
  static constexpr int kOrdersTold = 31;
  std::array<double, kOrdersTold> byOrder;
  double path;

  double totalShadow() const {
    double total = 0.0;
    for (const double s : shadow) total += s;
    return total;
  }
};

/// Outward unit normal of a face.
constexpr Triple<double> normalOfPrismFace(int face) {
  constexpr double kWide = 0.86602540378443864676;
  constexpr Triple<double> kNormals[kPrismFaces] = {{1.0, 0.0, 0.0},  {0.5, kWide, 0.0},   {-0.5, kWide, 0.0},
                                                    {-1.0, 0.0, 0.0}, {-0.5, -kWide, 0.0}, {0.5, -kWide, 0.0},
                                                    {0.0, 0.0, 1.0},  {0.0, 0.0, -1.0}};
  return kNormals[face];
}

/// Where light of one class goes; of a single direction, or of the lanes of T. Vectors in the crystal's frame.
template <class T>
struct ClassExit {
  Triple<T> lightDir;  // unit; grazing where the light does not get out
  T transmittance;     // of the exit face; 0 under total reflection
  T excess;            // squared cosine outside; at most 0 under total reflection
};

/// A face's normal times a number for each lane.
template <class T>
PARHELION_INLINE Triple<T> along(const Triple<double>& normal, const T& by) {
  return {by * normal.x, by * normal.y, by * normal.z};
}
template <class T>
PARHELION_INLINE T dotNormal(const Triple<double>& normal, const Triple<T>& v) {
  return normal.x * v.x + normal.y * v.y + normal.z * v.z;
}

/// Light of a class, whose entry is lit by `lightDir`, unit vectors. `index` of the ice over that of air.
template <class T>
PARHELION_INLINE ClassExit<T> exitOf(const PrismClass& of, const Triple<T>& lightDir, const RelativeIndexOf<T>& index) {
  // Inside, light has direction s + lambda n with the index as its length (Snell), n the entry's normal; then the
  // element acts, and on the way out the component along the face is kept.
  const Triple<double> entry = normalOfPrismFace(of.entry), exit = normalOfPrismFace(of.exit);
  const T in = higher(-dotNormal(entry, lightDir), T{});
  const Triple<T> inside = lightDir + along(entry, T(in - squareRoot(T(index.excess + in * in))));
  const int plane = of.element % kPlaneElements;
  const double c = kThirdCos[plane % 3], s = kThirdSin[plane % 3];
  const T x = c * inside.x - s * inside.y, y = s * inside.x + c * inside.y;
  const T mirroredX = -(c * inside.x + s * inside.y), mirroredY = c * inside.y - s * inside.x;
  const Triple<T> at{plane < 3 ? x : mirroredX, plane < 3 ? y : mirroredY,
                     of.element < kPlaneElements ? inside.z : -inside.z};
  const T onto = dotNormal(exit, at);
  ClassExit<T> result;
  result.excess = onto * onto - index.excess;
  const MaskOf<T> leaves = (result.excess > 0.0) & (onto > 0.0);
  const T out = squareRoot(higher(result.excess, T{}));
  result.lightDir = at + along(exit, T(out - onto));
  // Under total reflection what is left runs along the face and is longer than 1.
  const T length2 = dot(result.lightDir, result.lightDir);
  const T shrink = select(result.excess > 0.0, all<T>(1.0), 1.0 / squareRoot(length2));
  result.lightDir = shrink * result.lightDir;
  // Fresnel from outside and from inside is the same.
  result.transmittance = select(leaves, 1.0 - fresnel(out, index).reflectance, T{});
  return result;
}

/// The angle between unit vectors, exact to rounding everywhere.
template <class T>
PARHELION_INLINE T angleBetweenUnit(const Triple<T>& a, const Triple<T>& b) {
  const Triple<T> apart = a - b, together = a + b;
  return 2.0 * arctangent(squareRoot(dot(apart, apart)), squareRoot(dot(together, together)));
}

/// Whether light of a class leaves in its direction of arrival, however it came: straight on through opposite faces.
constexpr bool isUndeviated(const PrismClass& of) { return of.element == 0 && of.exit == oppositeFace(of.entry); }

}  // namespace parhelion
