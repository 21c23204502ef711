// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "math/arctangent.h"
#include "sky/camera_settings.h"

namespace parhelion {

/// A camera as plain numbers that lanes can run on; see Camera.
struct Lens {
  Projection projection;
  double width, height;               // pixels
  Triple<double> right, up, forward;  // world, orthonormal
  double centreX, centreY, focal;     // pixels
  double minCosine;                   // of angles from the axis inside the image circle
  Distortion distortion;

  /// A place in the picture, pixel coordinates, or none where `inside` does not hold.
  template <class T>
  struct Place {
    MaskOf<T> inside;
    T x, y;
  };

  /// Where the sky point toward the unit world vector `toSky` appears in the picture.
  template <class T>
  PARHELION_INLINE Place<T> project(const Triple<T>& toSky) const {
    const auto [seen, px, py] = place(toSky);
    const MaskOf<T> inside = seen & (px >= 0.0) & (px < width) & (py >= 0.0) & (py < height);
    return {inside, px, py};
  }

  /// The same, also beyond the picture's borders: `inside` says only that the projection can show the point.
  template <class T>
  PARHELION_INLINE Place<T> place(const Triple<T>& toSky) const {
    Triple<T> v{along(right, toSky), along(up, toSky), along(forward, toSky)};
    MaskOf<T> seen = v.z == v.z;
    T x, y;  // focal lengths, y up
    if (projection == Projection::equirectangular) {
      x = arctangent(v.x, v.z);
      y = arctangent(v.y, squareRoot(v.x * v.x + v.z * v.z));
    } else {
      seen = v.z >= minCosine;
      // The antipode is the whole image circle and has no direction of its own: give it the left. The square of this
      // sine is still a normal number.
      constexpr double kLeastSine = 1e-150;
      const MaskOf<T> antipode = (v.z < 0.0) & (v.x * v.x + v.y * v.y < kLeastSine * kLeastSine);
      v.x = select(antipode, all<T>(-kLeastSine), v.x);
      v.y = select(antipode, T{}, v.y);
      const T factor = radiusPerSine(v);
      x = v.x * factor;
      y = v.y * factor;
      if (!distortion.none()) {
        const T moved = distortion.factor(x * x + y * y);
        x = x * moved;
        y = y * moved;
      }
    }
    return {seen, centreX + x * (focal * kShrink), centreY - y * (focal * kShrink)};
  }

 private:
  // The picture is shrunk by this much toward its centre, so that light exactly on the border or on the image circle
  // (the horizon, the poles, the antisolar point) falls inside in spite of rounding, which is a thousand times smaller.
  // 1e-12 of half a picture is far below a pixel.
  static constexpr double kShrink = 1.0 - 1e-12;

  template <class T>
  static PARHELION_INLINE T along(const Triple<double>& axis, const Triple<T>& v) {
    return axis.x * v.x + axis.y * v.y + axis.z * v.z;
  }

  /// 1 + cos theta of a unit camera vector without cancellation near the antipode of the axis.
  template <class T>
  static PARHELION_INLINE T onePlusCosine(const Triple<T>& v) {
    return select(v.z > 0.0, 1.0 + v.z, (v.x * v.x + v.y * v.y) / (1.0 - v.z));
  }

  /// r / sin theta, r in focal lengths: the factor from the camera vector's (x, y) to the picture.
  template <class T>
  PARHELION_INLINE T radiusPerSine(const Triple<T>& v) const {
    switch (projection) {
      case Projection::rectilinear:
        return 1.0 / v.z;
      case Projection::fisheyeEqualArea:
        return squareRoot(2.0 / onePlusCosine(v));
      case Projection::fisheyeStereographic:
        return 2.0 / onePlusCosine(v);
      case Projection::fisheyeEquidistant: {
        const T sine = squareRoot(v.x * v.x + v.y * v.y);
        return select(sine > 0.0, arctangent(sine, v.z) / sine, all<T>(1.0));
      }
      case Projection::fisheyeOrthographic:
      case Projection::equirectangular:
        break;
    }
    return all<T>(1.0);
  }
};

}  // namespace parhelion
