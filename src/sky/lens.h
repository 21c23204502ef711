// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>

#include "sky/camera_settings.h"
#include "sky/projections.h"

namespace parhelion {

/// A camera as plain numbers that lanes can run on; see Camera.
struct Lens {
  Projection projection;
  double width, height;               // pixels
  Triple<double> right, up, forward;  // world, orthonormal
  double centreX, centreY;            // pixels; of the left one of two discs
  double discStep;                    // pixels from the left to the right one of two
  double focal;                       // pixels
  double lowest;                      // height of a unit vector, below which nothing is seen
  double minCosine;                   // of angles from the axis inside the image circle
  bool isDistorted;
  Distortion distortion;

  // The picture is shrunk by this much toward its centre, so that light exactly on the border or on the image circle
  // (the horizon, the poles, the antisolar point) falls inside in spite of rounding, which is a thousand times smaller.
  // 1e-12 of half a picture is far below a pixel.
  static constexpr double kShrink = 1.0 - 1e-12;

  /// Where the sky point toward the unit world vector `toSky` appears in the picture, pixel coordinates.
  template <class T>
  PARHELION_INLINE PicturePlace<T> project(const Triple<T>& toSky) const {
    return withinBorders(place(toSky));
  }

  /// The same, also beyond the picture's borders: `inside` says only that the projection can show the point.
  template <class T>
  PARHELION_INLINE PicturePlace<T> place(const Triple<T>& toSky) const {
    PicturePlace<T> found = visitProjection(
        projection, [&](auto facts) __attribute__((always_inline)) { return placeInFrame(facts, inFrame(toSky)); });
    found.inside = found.inside & isAbove(toSky);
    return found;
  }

  /// The same, but what lies a little beyond the image circle has the place where the projection goes on.
  template <class T>
  PARHELION_INLINE PicturePlace<T> placeBeyond(const Triple<T>& toSky) const {
    PicturePlace<T> found = visitProjection(
        projection, [&](auto facts)
                        __attribute__((always_inline)) { return placeInFrame<true>(facts, inFrame(toSky)); });
    found.inside = found.inside & isAbove(toSky);
    return found;
  }

  // The steps of project(), for loops over many directions through the projection of these `facts`.

  /// Whether a direction is not below a horizon that is cut.
  template <class T>
  PARHELION_INLINE MaskOf<T> isAbove(const Triple<T>& toSky) const {
    return toSky.z >= lowest;
  }

  /// A direction of the world in the camera's frame: right, up, forward.
  template <class T>
  PARHELION_INLINE Triple<T> inFrame(const Triple<T>& toSky) const {
    return {along(right, toSky), along(up, toSky), along(forward, toSky)};
  }

  /// Does so for the direction's mirror image in the sun's vertical plane, too, which takes few more steps.
  template <class T>
  PARHELION_INLINE std::pair<Triple<T>, Triple<T>> bothInFrame(const Triple<T>& toSky) const {
    const auto [x, mirroredX] = bothAlong(right, toSky);
    const auto [y, mirroredY] = bothAlong(up, toSky);
    const auto [z, mirroredZ] = bothAlong(forward, toSky);
    return {{x, y, z}, {mirroredX, mirroredY, mirroredZ}};
  }

  template <class Facts, class T>
  PARHELION_INLINE PicturePlace<T> projectFrame(Facts facts, const Triple<T>& v) const {
    return withinBorders(placeInFrame(facts, v));
  }

  /// A place, but `inside` only within the picture's borders.
  template <class T>
  PARHELION_INLINE PicturePlace<T> withinBorders(const PicturePlace<T>& place) const {
    const auto& [seen, x, y] = place;
    const MaskOf<T> inside = seen & (x >= 0.0) & (x < width) & (y >= 0.0) & (y < height);
    return {inside, x, y};
  }

 private:
  template <bool goesOn = false, class Facts, class T>
  PARHELION_INLINE PicturePlace<T> placeInFrame(Facts facts, const Triple<T>& v) const {
    if constexpr (facts.discs > 1) {
      const MaskOf<T> back = v.z < 0.0;
      const Triple<T> turned{select(back, -v.x, v.x), v.y, select(back, -v.z, v.z)};
      PicturePlace<T> place = inPixels(azimuthalPlace<goesOn>(facts, turned));
      place.x = place.x + select(back, all<T>(discStep), T{});
      return place;
    } else if constexpr (facts.isAzimuthal) {
      return inPixels(azimuthalPlace<goesOn>(facts, v));
    } else {
      return inPixels(facts.place(v));
    }
  }

  template <class T>
  PARHELION_INLINE PicturePlace<T> inPixels(const PicturePlace<T>& place) const {
    return {place.inside, centreX + place.x * (focal * kShrink), centreY - place.y * (focal * kShrink)};
  }

  template <class T>
  static PARHELION_INLINE T along(const Triple<double>& axis, const Triple<T>& v) {
    return axis.x * v.x + axis.y * v.y + axis.z * v.z;
  }

  /// along() of a vector and of its mirror image, to the bit.
  template <class T>
  static PARHELION_INLINE std::pair<T, T> bothAlong(const Triple<double>& axis, const Triple<T>& v) {
    const T x = axis.x * v.x, y = axis.y * v.y, z = axis.z * v.z;
    return {x + y + z, x - y + z};
  }

  /// In focal lengths, y up, of a direction of the camera's frame.
  template <bool goesOn, class Facts, class T>
  PARHELION_INLINE PicturePlace<T> azimuthalPlace(Facts facts, Triple<T> v) const {
    const MaskOf<T> seen = v.z >= minCosine;
    // What is not seen may have any place. Ahead of the camera there is less to do.
    if constexpr (!goesOn) v.z = select(seen, v.z, all<T>(1.0));
    if (anyOf(v.z <= 0.0)) {
      // The antipode is the whole image circle and has no direction of its own: give it the left. The square of this
      // sine is still a normal number.
      constexpr double kLeastSine = 1e-150;
      const MaskOf<T> antipode = (v.z < 0.0) & (v.x * v.x + v.y * v.y < kLeastSine * kLeastSine);
      v.x = select(antipode, all<T>(-kLeastSine), v.x);
      v.y = select(antipode, T{}, v.y);
    }
    const T factor = facts.radiusPerSine(v);
    T x = v.x * factor, y = v.y * factor;
    if (isDistorted) {
      const T moved = distortion.factor(x * x + y * y);
      x = x * moved;
      y = y * moved;
    }
    return {seen, x, y};
  }
};

}  // namespace parhelion
