// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace parhelion {

// Spectral powers of ideal lights at a wavelength (nm), relative to that at 560 nm.

/// A black body of `temperature` (kelvin). Planck's law.
double blackBody(double temperature, double wavelength);

/// CIE standard illuminant A, an incandescent lamp. ISO/CIE 11664-2.
double illuminantA(double wavelength);

/// Daylight of a correlated colour temperature from 4000 to 25000 kelvin, on today's scale of temperatures; 360-830 nm.
/// CIE 015:2018.
class Daylight {
 public:
  explicit Daylight(double temperature);

  double operator()(double wavelength) const;

 private:
  double m1_, m2_;  // weights of the components S1 and S2
};

/// Illuminant D50, D55, D65 or D75 by its nominal temperature, 5000, 5500, 6500 or 7500 kelvin. It was defined when the
/// second radiation constant was taken for 1.4380e-2 m K; on today's scale D65 is daylight of 6504 kelvin.
Daylight illuminantD(double nominalTemperature);

}  // namespace parhelion
