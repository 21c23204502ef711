// SPDX-License-Identifier: Apache-2.0
#include "math/portable.h"

#include <sleef.h>

namespace parhelion::portable {

SinCos sincos(double x) {
  const auto r = Sleef_cinz_sincosd1_u10purec(x);
  return {r.x, r.y};
}
double sin(double x) { return Sleef_cinz_sind1_u10purec(x); }
double cos(double x) { return Sleef_cinz_cosd1_u10purec(x); }
double tan(double x) { return Sleef_cinz_tand1_u10purec(x); }
double atan2(double y, double x) { return Sleef_cinz_atan2d1_u10purec(y, x); }
double exp(double x) { return Sleef_cinz_expd1_u10purec(x); }
double log(double x) { return Sleef_cinz_logd1_u10purec(x); }

}  // namespace parhelion::portable
