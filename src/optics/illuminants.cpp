// SPDX-License-Identifier: Apache-2.0
#include "optics/illuminants.h"

#include <algorithm>
#include <cmath>

#include "math/portable.h"
#include "optics/tables.h"

namespace parhelion {

namespace {

constexpr double kReference = 560.0;  // nm

/// Planck's law with x = c2 / T (nm).
double planck(double x, double wavelength) {
  const double ratio = kReference / wavelength;
  const double power = ratio * ratio * ratio * ratio * ratio;
  return power * (portable::exp(x / kReference) - 1.0) / (portable::exp(x / wavelength) - 1.0);
}

/// Rounded to three decimals, as the CIE rounds the weights of S1 and S2.
double rounded(double weight) { return std::round(1000.0 * weight) / 1000.0; }

}  // namespace

double blackBody(double temperature, double wavelength) {
  constexpr double kC2 = 1.438776877e7;  // nm K: h c / k, exact since the SI of 2019
  return planck(kC2 / temperature, wavelength);
}

double illuminantA(double wavelength) { return planck(1.435e7 / 2848.0, wavelength); }

Daylight::Daylight(double temperature) {
  const double t = 1000.0 / temperature;
  // Chromaticity on the daylight locus.
  const double x = temperature <= 7000.0 ? 0.244063 + t * (0.09911 + t * (2.9678 - t * 4.6070))
                                         : 0.237040 + t * (0.24748 + t * (1.9018 - t * 2.0064));
  const double y = -0.275 + x * (2.870 - x * 3.000);
  const double m = 0.0241 + 0.2562 * x - 0.7341 * y;
  m1_ = rounded((-1.3515 - 1.7703 * x + 5.9114 * y) / m);
  m2_ = rounded((0.0300 - 31.4424 * x + 30.0717 * y) / m);
}

double Daylight::operator()(double wavelength) const {
  const double at = std::clamp((wavelength - kVisibleFirst) / kDaylightStep, 0.0, double(kDaylightNodes - 1));
  const int node = std::min(static_cast<int>(at), kDaylightNodes - 2);
  const Vec3 s = kDaylight[node] + (at - node) * (kDaylight[node + 1] - kDaylight[node]);
  return (s.x + m1_ * s.y + m2_ * s.z) / 100.0;  // S0 is 100 at 560 nm, where S1 and S2 are 0
}

Daylight illuminantD(double nominalTemperature) { return Daylight(nominalTemperature * 1.4388 / 1.4380); }

}  // namespace parhelion
