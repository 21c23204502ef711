// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "math/conventions.h"
#include "math/portable.h"

namespace parhelion {

/// The windowed sinc of Gonzato & Marchand (2001) at distance t (pixels) from its centre: sinc(t/Ts) under a Hann
/// window that ends at k Ts. Beyond that, as in the corners of its square, 0. Ts = 0 is a single pixel.
inline double windowedSinc(double t, double period, double lobes) {
  if (t == 0.0) return 1.0;
  const double u = t / period;  // infinite for Ts = 0
  if (!(u < lobes)) return 0.0;
  const double hann = 0.5 + 0.5 * portable::cos(kPi * u / lobes);
  return hann * portable::sin(kPi * u) / (kPi * u);
}

}  // namespace parhelion
