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

/// Whether bundles of one wavelength meet different indices.
bool differsByBundle(const IceSettings& ice);

}  // namespace parhelion
