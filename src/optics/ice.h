// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "optics/light_settings.h"

namespace parhelion {

/// Refractive index of ice Ih relative to air at `wavelength` (nm, 350-900; the ends' values beyond).
/// Warren & Brandt 2008: exact at the table's nodes, linear in wavelength between, where their digits end at 1e-4.
double iceIndex(double wavelength);

/// The index that the settings give at `wavelength` (nm).
double refractiveIndex(const IceSettings& ice, double wavelength);

}  // namespace parhelion
