// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "beam/prism_light.h"
#include "beam/prism_tracer.h"

// All light of a class (PrismClass) leaves a prism in one direction, and so does what a face reflects outside. Both are
// told by numbers here.

namespace parhelion {

/// Numbers of classes from inside, and of all: what is reflected outside follows, by face.
inline constexpr int kInsideClasses = kPrismFaces * kPrismElements * kPrismFaces;
inline constexpr int kLightClasses = kInsideClasses + kPrismFaces;

/// What a number stands for.
struct LightClass {
  PrismClass of;  // of what is reflected outside only the entry counts
  bool outside;

  explicit LightClass(int number)
      : of(number < kInsideClasses ? PrismClass{number / (kPrismElements * kPrismFaces),
                                                number / kPrismFaces % kPrismElements, number % kPrismFaces}
                                   : PrismClass{number - kInsideClasses, 0, 0}),
        outside(number >= kInsideClasses) {}

  bool isUndeviated() const { return !outside && parhelion::isUndeviated(of); }

  /// Where its light goes. Of what is reflected outside, the reflectance stands for the transmittance.
  template <class T>
  PARHELION_INLINE ClassExit<T> exit(const Triple<T>& lightDir, const RelativeIndexOf<T>& index) const {
    if (!outside) return exitOf(of, lightDir, index);
    const Triple<T> normal = normalOfPrismFace<T>(of.entry);
    const T in = higher(T(-dot(normal, lightDir)), T{});
    return {reflect(lightDir, normal, in), fresnel(in, index).reflectance, all<T>(1.0)};
  }

  /// The same of light at an angle zeta from -c and at an azimuth phi, by the direction of its part across c (x), what
  /// is at right angles to that (y), and c (z).
  template <class T>
  PARHELION_INLINE ClassExit<T> exitAcross(double sinZeta, double cosZeta, const T& sinPhi, const T& cosPhi,
                                           const RelativeIndexOf<T>& index) const {
    ClassExit<T> found = exit(Triple<T>{sinZeta * cosPhi, sinZeta * sinPhi, all<T>(-cosZeta)}, index);
    const Triple<T> dir = found.lightDir;
    found.lightDir = {dir.x * cosPhi + dir.y * sinPhi, dir.y * cosPhi - dir.x * sinPhi, dir.z};
    return found;
  }
};

/// Calls f(number, light) for each class with light: what meets its exit, or a face from outside, in the units of
/// shadows.
template <class F>
void forEachClass(const PrismLight& light, const F& f) {
  for (int entry = 0; entry < kPrismFaces; ++entry) {
    const auto e = static_cast<std::size_t>(entry);
    if (light.shadow[e] == 0.0) continue;
    const double goesIn = light.shadow[e] * (1.0 - light.reflectance[e]);
    if (light.mirrored[e] > 0.0) f(kInsideClasses + entry, light.mirrored[e]);
    if (!(goesIn > 0.0)) continue;
    for (int element = 0; element < kPrismElements; ++element)
      for (int exit = 0; exit < kPrismFaces; ++exit)
        if (const double arrived = light.arrived[e][static_cast<std::size_t>(element)][static_cast<std::size_t>(exit)];
            arrived > 0.0)
          f((entry * kPrismElements + element) * kPrismFaces + exit, goesIn * arrived);
  }
}

/// A direction of light in the crystal's frame by its azimuth and its angle from -c (rad).
Triple<double> lightDirAt(double phi, double zeta);

/// Where light of a direction is traced.
struct TracedDirection {
  Vec3 inside, outside;
  bool differ;
};

/// Light in a plane of symmetry of the side faces, or across c, can go round in the prism for ever: a limit that no
/// light beside it comes near. There what becomes of it inside is that of light 0.01 degrees beside, on the side of
/// azimuth `towards`.
TracedDirection tracedDirection(double phi, double zeta, double towards);

/// Traces light of a direction.
template <class Tracer>
void traceAt(Tracer& tracer, double phi, double zeta, double towards, PrismLight& light) {
  const TracedDirection at = tracedDirection(phi, zeta, towards);
  tracer.trace(at.inside, light);
  if (at.differ) tracer.meetOutside(at.outside, light);
}

}  // namespace parhelion
