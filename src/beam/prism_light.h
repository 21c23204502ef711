// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "beam/prism_group.h"
#include "math/arctangent.h"
#include "math/conventions.h"
#include "math/lanes.h"
#include "optics/interface.h"

namespace parhelion {

/// Faces of a prism by place: 0 ... 5 are face numbers 3 ... 8, 6 and 7 the ends, 1 and 2.
inline constexpr int kPrismFaces = 8, kUpperEnd = 6, kLowerEnd = 7;
constexpr int oppositeFace(int face) { return face < kUpperEnd ? (face + 3) % 6 : 13 - face; }

/// Light that entered by one face, was reflected as one element of the group of reflections, and meets another face.
/// All of it leaves in one direction.
struct PrismClass {
  int entry, element, exit;
};

/// What becomes of parallel light in a prism that stands still: exact but for what is cut off.
struct PrismLight {
  /// Of each face, shadow (area times cosine, crystal units squared; 0 in the dark) and reflectance outside.
  std::array<double, kPrismFaces> shadow, reflectance;

  /// The same shadows, 0 where what is reflected outside is not wanted.
  std::array<double, kPrismFaces> mirrored;

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

/// Outward unit normal of a face, the same in all lanes of T.
template <class T>
PARHELION_INLINE Triple<T> normalOfPrismFace(int face) {
  constexpr double kWide = 0.86602540378443864676;
  constexpr double kNormals[kPrismFaces][3] = {{1.0, 0.0, 0.0},  {0.5, kWide, 0.0},   {-0.5, kWide, 0.0},
                                               {-1.0, 0.0, 0.0}, {-0.5, -kWide, 0.0}, {0.5, -kWide, 0.0},
                                               {0.0, 0.0, 1.0},  {0.0, 0.0, -1.0}};
  return {all<T>(kNormals[face][0]), all<T>(kNormals[face][1]), all<T>(kNormals[face][2])};
}

inline Vec3 normalVectorOf(int face) {
  const auto [x, y, z] = normalOfPrismFace<double>(face);
  return {x, y, z};
}

/// Where light of one class goes; of a single direction, or of the lanes of T. Vectors in the crystal's frame.
template <class T>
struct ClassExit {
  Triple<T> lightDir;  // unit; grazing where the light does not get out
  T transmittance;     // of the exit face; 0 under total reflection
  T excess;            // squared cosine outside; at most 0 under total reflection
};

/// Light of a class, whose entry is lit by `lightDir`, unit vectors. `index` of the ice over that of air.
template <class T>
PARHELION_INLINE ClassExit<T> exitOf(const PrismClass& of, const Triple<T>& lightDir, const RelativeIndexOf<T>& index) {
  // Inside, light has direction s + lambda n with the index as its length (Snell), n the entry's normal; then the
  // element acts, and on the way out the component along the face is kept.
  struct InPlane {
    T x, y;
  };
  const Triple<T> entry = normalOfPrismFace<T>(of.entry), exit = normalOfPrismFace<T>(of.exit);
  const T in = higher(T(-dot(entry, lightDir)), T{});
  const Triple<T> inside = lightDir + T(in - squareRoot(T(index.excess + in * in))) * entry;
  const InPlane turned = inPlane(of.element % kPlaneElements, InPlane{inside.x, inside.y});
  const Triple<T> at{turned.x, turned.y, of.element < kPlaneElements ? inside.z : -inside.z};
  const T onto = dot(exit, at);
  ClassExit<T> result;
  result.excess = onto * onto - index.excess;
  const MaskOf<T> leaves = (result.excess > 0.0) & (onto > 0.0);
  const T out = squareRoot(higher(result.excess, T{}));
  result.lightDir = at + T(out - onto) * exit;
  // Under total reflection what is left runs along the face and is longer than 1.
  const T shrink = select(result.excess > 0.0, all<T>(1.0), T(1.0 / squareRoot(dot(result.lightDir, result.lightDir))));
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
