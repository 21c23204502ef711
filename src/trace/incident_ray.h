// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "crystal/crystal.h"
#include "optics/spectrum.h"
#include "trace/crystal_optics.h"

namespace parhelion {

/// One ray of sunlight as it meets a crystal.
struct IncidentRay {
  std::uint64_t index = 0;
  std::uint64_t bundle = 0;  // of rays that differ in wavelength alone
  int population = 0;
  Crystal crystal{};
  Mat3 crystalToWorld{1.0};
  Vec3 lightDirWorld{};    // unit, from the sun's disc toward the crystal
  Vec3 lightDirCrystal{};  // the same in the crystal's frame
  EntryPoint entry{};      // crystal frame
  double shadow = 0.0;     // projected area of this crystal in this orientation, crystal units squared
  SpectralSample light;
  double iceIndex = 1.31;  // refractive index at this wavelength
  double weight = 1.0;     // intercepted light this ray stands for; nearly always 1
  CrystalOptics optics{};
  double absorption = 0.0;  // per crystal unit, where the crystal absorbs
  double wave = 0.0;        // the wavelength, crystal units, where it diffracts
};

}  // namespace parhelion
