// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "math/lanes.h"

namespace parhelion {

/// The angle of (x, y) from the x axis, in [-pi, pi], within 5e-16; 0 for (0, 0). Being made of additions, products and
/// quotients alone, the same bits everywhere.
template <class T>
PARHELION_INLINE T arctangent(const T& y, const T& x) {
  const T a = higher(y, -y), b = higher(x, -x);
  const T large = higher(a, b), small = lower(a, b);
  // Of the quotient in [0, 1], an eighth of a turn is taken off where that leaves less: |t| <= tan(pi / 8).
  const MaskOf<T> above = small > 0.41421356237309503 * large;
  const T divisor = select(above, small + large, large);
  const T t = select(divisor > 0.0, select(above, small - large, small) / divisor, T{});
  const T z = t * t;
  // atan(t) / t in t^2, interpolated at Chebyshev nodes: error 2e-18.
  const T ratio =
      1.0 +
      z * (-0.3333333333333312 +
           z * (0.1999999999994089 +
                z * (-0.14285714279250233 +
                     z * (0.11111110744919134 +
                          z * (-0.09090896809048848 +
                               z * (0.07692045330629599 +
                                    z * (-0.06662951810494483 +
                                         z * (0.05846878274243126 +
                                              z * (-0.05035102351284496 +
                                                   z * (0.03796525474528706 + z * (-0.017805394203655563)))))))))));
  T angle = t * ratio;
  angle = select(above, angle + 0.7853981633974483, angle);
  angle = select(a > b, 1.5707963267948966 - angle, angle);
  angle = select(x < 0.0, 3.141592653589793 - angle, angle);
  return select(y < 0.0, -angle, angle);
}

}  // namespace parhelion
