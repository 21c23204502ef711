// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "optics/light_settings.h"

namespace parhelion {

/// Refractive index of ice Ih relative to air at `wavelength` (nm, 350-900; the ends' values beyond).
/// Warren & Brandt 2008: exact at the table's nodes, linear in wavelength between, where their digits end at 1e-4.
double iceIndex(double wavelength);

/// The index that the settings give a ray of this bundle (rays that share all but their wavelength) at `wavelength`
/// (nm). Of a mixture, two bundles in a row take the same, so that the bundles of even number see all of it.
double refractiveIndex(const IceSettings& ice, double wavelength, std::uint64_t bundle = 0);

/// Whether the settings know the imaginary part of the index.
bool knowsAbsorption(const IceSettings& ice);

/// The imaginary part k of the index at `wavelength` (nm): light is left by exp(-4 pi k / wavelength) of each length.
/// Where the settings do not know it, 0.
double imaginaryIndex(const IceSettings& ice, double wavelength);

/// Whether bundles of one wavelength meet different indices.
bool differsByBundle(const IceSettings& ice);

/// Whether bundles meet the same indices whatever their wavelength.
bool isWithoutDispersion(const IceSettings& ice);

}  // namespace parhelion
