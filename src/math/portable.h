// SPDX-License-Identifier: Apache-2.0
#pragma once

// Elementary functions whose last bits do not depend on the processor. The C library picks variants with fused
// multiply-adds where the machine has them; SLEEF's "cinz" functions are the same everywhere, within 1 ulp.

namespace parhelion::portable {

struct SinCos {
  double sin;
  double cos;
};

SinCos sincos(double x);
double sin(double x);
double cos(double x);
double tan(double x);
double atan2(double y, double x);
double exp(double x);
double log(double x);

}  // namespace parhelion::portable
