// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "optics/interface.h"
#include "trace/path_rule.h"

namespace parhelion {

/// What a face makes of the light that meets it; of a single ray, or of the lanes of T. Vector is Vec3, or Triple<T>.
template <class T, class Vector>
struct Branches {
  T reflected, transmitted;             // energy
  Vector reflectedDir, transmittedDir;  // unit to rounding; meaningless where a branch has no energy
};

/// The two branches of light of `energy` at a face. `towardLight` is the face's normal on the side the light comes
/// from; see reflect() and refract(). Each branch carries its share of the energy where that is at least `splitAbove`;
/// below, one carries all of it, picked by `random` in (0, 1). Either way no energy is lost, and paths end without a
/// bias.
template <class T, class Vector>
PARHELION_INLINE Branches<T, Vector> branch(const Vector& lightDir, const Vector& towardLight, const T& cosTheta_i,
                                            const RelativeIndexOf<T>& index, const T& energy, const T& splitAbove,
                                            const T& random) {
  const InterfaceOf<T> face = fresnel(cosTheta_i, index);
  const T whole = select(random < face.reflectance, energy, T{});
  const T reflected = select(energy >= splitAbove, energy * face.reflectance, whole);
  return {reflected, energy - reflected, reflect(lightDir, towardLight, cosTheta_i),
          refract(lightDir, towardLight, cosTheta_i, face.cosTheta_t, index)};
}

}  // namespace parhelion
