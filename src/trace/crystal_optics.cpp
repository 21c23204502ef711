// SPDX-License-Identifier: Apache-2.0
#include "trace/crystal_optics.h"

#include <cmath>

#include "math/conventions.h"
#include "math/portable.h"
#include "math/tabulated_density.h"

namespace parhelion {

namespace {

/// Normal numbers as far as 6 standard deviations: 2e-9 of them lie beyond.
const TabulatedDensity& slopes() {
  static const TabulatedDensity table([](double x) { return portable::exp(-0.5 * x * x); }, -6.0, 6.0, 2048);
  return table;
}

/// Of t in fringeOf(). From the 16th zero on fringes are taken together: no picture tells them apart. Beyond 10^4 of
/// them lie 1e-5 of the light.
const TabulatedDensity& fringes() {
  constexpr double kTold = 16.0, kMost = 1e4;
  const auto density = [](double t) {
    const double x = t / (1.0 - t), phase = kPi * x, perT = (1.0 + x) * (1.0 + x);
    if (x > kTold) return 0.5 * perT / (phase * phase);
    if (x == 0.0) return 1.0;
    const double amplitude = portable::sin(phase) / phase;
    return amplitude * amplitude * perT;
  };
  static const TabulatedDensity table(density, 0.0, kMost / (1.0 + kMost), 8192);
  return table;
}

}  // namespace

CrystalOptics crystalOptics(bool absorbs, bool diffracts, double distortion) {
  return {absorbs, diffracts, portable::tan(distortion), slopes().quantile(), fringes().quantile()};
}

}  // namespace parhelion
