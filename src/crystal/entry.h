// SPDX-License-Identifier: Apache-2.0
#pragma once

// Where light meets a convex crystal first: a point of its lit side, uniform over its shadow. Of a single crystal, or
// of the lanes of T. Directions and points are in the crystal's frame.

#include "crystal/face_table.h"
#include "math/lanes.h"

namespace parhelion {

/// The shadows that a crystal's faces cast on a plane across the light, crystal units squared.
template <class T>
struct Shadows {
  T face[kMaxFaces];  // as many as the crystal has; 0 for faces in the dark
  T total;
};
template <class T>
PARHELION_INLINE Shadows<T> castShadows(const FaceTable& faces, const T& stretch, const Triple<T>& lightDir) {
  Shadows<T> shadows;
  shadows.total = T{};
  for (int f = 0; f < faces.faces; ++f) {
    const T cosine =
        -(faces.normal[0][f] * lightDir.x + faces.normal[1][f] * lightDir.y + faces.normal[2][f] * lightDir.z);
    const T area = faces.areaGrows[f] != 0.0 ? faces.area[f] * stretch : all<T>(faces.area[f]);
    shadows.face[f] = higher(cosine, T{}) * area;
    shadows.total += shadows.face[f];
  }
  return shadows;
}

/// A lit face, picked in proportion to its shadow by a number in (0, 1).
template <class T>
PARHELION_INLINE T litFace(const FaceTable& faces, const Shadows<T>& shadows, const T& u) {
  T left = u * shadows.total, face{};
  for (int f = 0; f < faces.faces; ++f) {
    // What is left falls below zero at the face in which it ends, and stays there.
    face = select((left >= 0.0) & (shadows.face[f] > 0.0), all<T>(f), face);
    left -= shadows.face[f];
  }
  return face;
}

/// A uniform point of a face, for two numbers in (0, 1): a triangle of its fan by area, then a point in the triangle.
template <class T>
PARHELION_INLINE Triple<T> pointOnFace(const FaceTable& faces, const T& stretch, const T& face, const T& u1,
                                       const T& u2) {
  T left = u1 * lookUp(faces.area.data(), face), triangle = face * static_cast<double>(faces.fan);
  for (int j = 0; j + 1 < faces.fan; ++j) {
    const T limit = lookUp(faces.triangleLimit.data(), triangle);
    const MaskOf<T> beyond = left > limit;
    left = select(beyond, left - limit, left);
    triangle = select(beyond, triangle + 1.0, triangle);
  }
  // What is left of u1 is uniform again; the square root makes the triangle uniform.
  const T s = squareRoot(lower(left / lookUp(faces.triangleArea.data(), triangle), all<T>(1.0)));
  const T alongB = s * (1.0 - u2), alongC = s * u2;
  const Triple<T> point = lookUpTriple(faces.corner, triangle) + alongB * lookUpTriple(faces.ab, triangle) +
                          alongC * lookUpTriple(faces.ac, triangle);
  return {point.x, point.y, point.z * stretch};
}

}  // namespace parhelion
