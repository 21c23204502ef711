// SPDX-License-Identifier: Apache-2.0
#pragma once

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
  Distortion distortion;

  /// Where the sky point toward the unit world vector `toSky` appears in the picture, pixel coordinates.
  template <class T>
  PARHELION_INLINE PicturePlace<T> project(const Triple<T>& toSky) const {
    const auto [seen, px, py] = place(toSky);
    const MaskOf<T> inside = seen & (px >= 0.0) & (px < width) & (py >= 0.0) & (py < height);
    return {inside, px, py};
  }

  /// The same, also beyond the picture's borders: `inside` says only that the projection can show the point.
  template <class T>
  PARHELION_INLINE PicturePlace<T> place(const Triple<T>& toSky) const {
    const Triple<T> v{along(right, toSky), along(up, toSky), along(forward, toSky)};
    PicturePlace<T> found = visitProjection(
        projection, [&](auto facts) __attribute__((always_inline))->PicturePlace<T> {
          if constexpr (facts.discs > 1) {
            const MaskOf<T> back = v.z < 0.0;
            const Triple<T> turned{select(back, -v.x, v.x), v.y, select(back, -v.z, v.z)};
            PicturePlace<T> place = inPixels(azimuthalPlace(facts, turned));
            place.x = place.x + select(back, all<T>(discStep), T{});
            return place;
          } else if constexpr (facts.isAzimuthal) {
            return inPixels(azimuthalPlace(facts, v));
          } else {
            return inPixels(facts.place(v));
          }
        });
    found.inside = found.inside & (toSky.z >= lowest);
    return found;
  }

 private:
  // The picture is shrunk by this much toward its centre, so that light exactly on the border or on the image circle
  // (the horizon, the poles, the antisolar point) falls inside in spite of rounding, which is a thousand times smaller.
  // 1e-12 of half a picture is far below a pixel.
  static constexpr double kShrink = 1.0 - 1e-12;

  template <class T>
  PARHELION_INLINE PicturePlace<T> inPixels(const PicturePlace<T>& place) const {
    return {place.inside, centreX + place.x * (focal * kShrink), centreY - place.y * (focal * kShrink)};
  }

  template <class T>
  static PARHELION_INLINE T along(const Triple<double>& axis, const Triple<T>& v) {
    return axis.x * v.x + axis.y * v.y + axis.z * v.z;
  }

  /// In focal lengths, y up, of a direction of the camera's frame.
  template <class Facts, class T>
  PARHELION_INLINE PicturePlace<T> azimuthalPlace(Facts facts, Triple<T> v) const {
    const MaskOf<T> seen = v.z >= minCosine;
    // The antipode is the whole image circle and has no direction of its own: give it the left. The square of this
    // sine is still a normal number.
    constexpr double kLeastSine = 1e-150;
    const MaskOf<T> antipode = (v.z < 0.0) & (v.x * v.x + v.y * v.y < kLeastSine * kLeastSine);
    v.x = select(antipode, all<T>(-kLeastSine), v.x);
    v.y = select(antipode, T{}, v.y);
    const T factor = facts.radiusPerSine(v);
    T x = v.x * factor, y = v.y * factor;
    if (!distortion.none()) {
      const T moved = distortion.factor(x * x + y * y);
      x = x * moved;
      y = y * moved;
    }
    return {seen, x, y};
  }
};

}  // namespace parhelion
