// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "math/conventions.h"

namespace parhelion {

// Measured tables, one entry a nanometre from 360 to 830 nm.
inline constexpr int kVisibleFirst = 360;  // nm
inline constexpr int kVisibleLast = 830;   // nm
inline constexpr int kVisibleNodes = kVisibleLast - kVisibleFirst + 1;

/// CIE 1931 2-degree standard observer: x-bar, y-bar, z-bar. CIE 018, as tabulated by CVRL.
extern const std::array<Vec3, kVisibleNodes> kObserver1931;

/// Sunlight above the atmosphere, W m^-2 nm^-1. ASTM G173-03.
extern const std::array<double, kVisibleNodes> kSunExtraterrestrial;

/// Direct and circumsolar sunlight at the ground under air mass 1.5, W m^-2 nm^-1. ASTM G173-03.
extern const std::array<double, kVisibleNodes> kSunAirMass1_5;

inline constexpr int kDaylightStep = 10;  // nm
inline constexpr int kDaylightNodes = (kVisibleLast - kVisibleFirst) / kDaylightStep + 1;

/// Components S0, S1, S2 of daylight from 360 to 830 nm: the mean of measured spectra and the two that change it most.
/// CIE 015:2018; Judd, MacAdam & Wyszecki 1964, J. Opt. Soc. Am. 54, 1031.
extern const std::array<Vec3, kDaylightNodes> kDaylight;

struct IceNode {
  double wavelength;  // nm
  double index;
  double k;  // the imaginary part
};

/// Refractive index of ice Ih at 266 K. Warren & Brandt 2008, J. Geophys. Res. 113, D14220.
extern const std::array<IceNode, 48> kIceIndex;

inline constexpr int kOzoneStep = 10;  // nm
inline constexpr int kOzoneNodes = 48;

/// Absorption cross section of ozone at 233 K, m^2: means over each 10 nm from 360 nm on. Serdyuchenko, Gorshelev,
/// Weber, Chehade & Burrows 2011 (IUP Bremen), averaged by Bruneton 2017, Precomputed Atmospheric Scattering.
extern const std::array<double, kOzoneNodes> kOzoneCrossSection;

}  // namespace parhelion
