// SPDX-License-Identifier: Apache-2.0
#pragma once

// Elementary functions whose last bits do not depend on the processor. The C library picks variants with fused
// multiply-adds where the machine has them; SLEEF's "cinz" functions are the same everywhere, within 1 ulp.

#include <sleef.h>

namespace parhelion::portable {

struct SinCos {
  double sin;
  double cos;
};

inline SinCos sincos(double x) {
  const auto r = Sleef_cinz_sincosd1_u10purec(x);
  return {r.x, r.y};
}
inline double sin(double x) { return Sleef_cinz_sind1_u10purec(x); }
inline double cos(double x) { return Sleef_cinz_cosd1_u10purec(x); }
inline double tan(double x) { return Sleef_cinz_tand1_u10purec(x); }
inline double atan2(double y, double x) { return Sleef_cinz_atan2d1_u10purec(y, x); }
inline double exp(double x) { return Sleef_cinz_expd1_u10purec(x); }
inline double log(double x) { return Sleef_cinz_logd1_u10purec(x); }

}  // namespace parhelion::portable
