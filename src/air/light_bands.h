// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "air/atmosphere.h"
#include "math/conventions.h"

namespace parhelion {

inline constexpr std::size_t kBands = 18;

/// A number for each band of light.
using Spectral = std::array<double, kBands>;

/// exp(-x) of each number, for x from 0, within 1e-11 of itself. In plain steps, which compilers do for several numbers
/// at a time, and which give the same bits on all processors.
Spectral attenuation(const Spectral& depth);

/// The visible light of the sun in bands, each of which the air treats as one wavelength.
struct LightBands {
  Spectral wavelength;                // nm
  std::array<Vec3, kBands> sunlight;  // above the air, square to it: CIE XYZ with Y in lux

  /// The colour of light that has such a share of the sun's in each band.
  Vec3 colourOf(const Spectral& share) const;
};

/// Bands of 20 nm from 380 to 740 nm; the first and the last reach to the ends of the observer's sight. Sunlight of
/// ASTM G173, 1931 observer, 683.002 lm/W.
const LightBands& sunBands();

/// All bands at the same wavelength (nm), with unit sunlight together: what they give is for unit irradiance.
LightBands oneWavelength(double wavelength);

/// What becomes of the part of the light scattered by aerosols that goes on nearly as it came: g^2 of it. Where light
/// is scattered many times, it is best taken for not scattered, with the rest scattered by a phase function of smaller
/// g. Delta-Eddington: Joseph, Wiscombe & Weinman 1976, J. Atmos. Sci. 33, 2452.
enum class ForwardLight { scattered, goesOn };

/// What the air's constituents do to each band.
struct AirSpectrum {
  AirSpectrum(const Atmosphere& air, const LightBands& bands, ForwardLight forward);

  /// Adds the optical depths of so many air masses.
  void addDepth(const OfAir& masses, Spectral& depth) const {
    for (std::size_t b = 0; b < kBands; ++b)
      depth[b] += rayleigh[b] * masses.rayleigh + ozone[b] * masses.ozone + aerosol[b] * masses.aerosol;
  }

  Spectral transmittance(const OfAir& masses) const {
    Spectral depth{};
    addDepth(masses, depth);
    return attenuation(depth);
  }

  Spectral rayleigh, ozone, aerosol;  // vertical optical depths
  Spectral scattering;                // by aerosols: the same of what they scatter
  double g;                           // of their phase function
};

/// Of what aerosols scatter, the share that does not go on nearly forwards.
inline double keptShare(const AirSpectrum& scattered, const AirSpectrum& goesOn) {
  return scattered.scattering[0] > 0.0 ? goesOn.scattering[0] / scattered.scattering[0] : 1.0;
}

}  // namespace parhelion
