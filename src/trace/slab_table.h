// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "crystal/crystal_mesh.h"
#include "math/lanes.h"

namespace parhelion {

/// What a ray meets next, of a single ray or of the lanes of T.
template <class T>
struct FaceMet {
  T face;      // index into the mesh's faces; kNoFace
  T distance;  // along the ray, >= 0, crystal units
  T cosine;    // of the ray's direction and the face's outward normal, > 0
};

/// The half-spaces behind a convex crystal's faces as slabs, plain numbers that lanes can run on. A slab is two
/// opposite faces, of which light can only meet one, or one face with nothing infinitely far on the other side.
struct SlabTable {
  static constexpr int kMost = kMaxFaces;
  int count = 0;
  std::array<double, kMost> x{}, y{}, z{};                // normal of `front`; that of `back` is its negative
  std::array<double, kMost> frontOffset{}, backOffset{};  // of the faces' planes at stretch 1
  std::array<double, kMost> front{}, back{};              // faces
  std::array<bool, kMost> grows{};                        // whether the offsets grow with the stretch

  /// Throws std::invalid_argument unless the mesh is convex.
  explicit SlabTable(const CrystalMesh& mesh);

  /// The nearest plane that light runs toward from `point` inside the crystal, `leftFace` aside.
  template <class T>
  PARHELION_INLINE FaceMet<T> next(const Triple<T>& point, const Triple<T>& lightDir, const T& stretch,
                                   const T& leftFace) const {
    // Distances are quotients gap / cosine; products compare them without dividing.
    T face = all<T>(-1.0), gap = all<T>(__builtin_inf()), cosine = all<T>(1.0);
    for (int i = 0; i < count; ++i) {
      const Triple<T> normal{all<T>(x[i]), all<T>(y[i]), all<T>(z[i])};
      const T approach = dot(normal, lightDir), height = dot(normal, point);
      const T scale = grows[i] ? stretch : all<T>(1.0);
      const MaskOf<T> backward = approach < 0.0;
      const T toward = select(backward, -approach, approach);
      const T met = select(backward, all<T>(back[i]), all<T>(front[i]));
      const T left = select(backward, backOffset[i] * scale + height, frontOffset[i] * scale - height);
      // A plane that the light runs along is never met, also where rounding has put the point outside it.
      const MaskOf<T> nearer = (toward > 0.0) & (met != leftFace) & (left * cosine < gap * toward);
      face = select(nearer, met, face);
      gap = select(nearer, left, gap);
      cosine = select(nearer, toward, cosine);
    }
    return {face, higher(gap / cosine, T{}), cosine};
  }
};

}  // namespace parhelion
