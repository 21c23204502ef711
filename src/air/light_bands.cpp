// SPDX-License-Identifier: Apache-2.0
#include "air/light_bands.h"

#include <algorithm>
#include <bit>
#include <cstdint>

#include "optics/tables.h"

namespace parhelion {

namespace {

constexpr double kLumensPerWatt = 683.002;
constexpr int kFirstBand = 380, kBandWidth = 20;  // nm

LightBands makeSunBands() {
  LightBands bands{};
  Spectral weights{};
  for (int i = 0; i < kVisibleNodes; ++i) {
    const int wavelength = kVisibleFirst + i;
    const auto node = static_cast<std::size_t>(i);
    const int whole = (wavelength - kFirstBand) / kBandWidth;
    const std::size_t band = wavelength < kFirstBand ? 0 : std::min(static_cast<std::size_t>(whole), kBands - 1);
    const Vec3 light = kLumensPerWatt * kSunExtraterrestrial[node] * kObserver1931[node];
    const double weight = light.x + light.y + light.z;
    bands.sunlight[band] += light;
    bands.wavelength[band] += weight * wavelength;
    weights[band] += weight;
  }
  for (std::size_t b = 0; b < kBands; ++b) bands.wavelength[b] /= weights[b];
  return bands;
}

}  // namespace

Spectral attenuation(const Spectral& depth) {
  // exp(-x) = 2^n exp(r), with n a whole number and |r| at most half of log 2, where Taylor's series to r^9 is enough.
  constexpr double kLog2 = 0.693147180559945309, kMost = 700.0;
  constexpr double kShift = 0x1.8p52;  // a sum with it ends in a whole number
  Spectral result;
  for (std::size_t b = 0; b < kBands; ++b) {
    const double x = -std::min(depth[b], kMost);
    const double shifted = x * (1.0 / kLog2) + kShift;
    const double r = x - (shifted - kShift) * kLog2;
    double sum = 1.0 / 362880.0;
    for (const double factorial : {40320.0, 5040.0, 720.0, 120.0, 24.0, 6.0, 2.0, 1.0, 1.0})
      sum = sum * r + 1.0 / factorial;
    const std::uint64_t power =
        std::bit_cast<std::uint64_t>(shifted) + 1023U;  // the exponent of 2^n as doubles have it
    result[b] = sum * std::bit_cast<double>(power << 52U);
  }
  return result;
}

Vec3 LightBands::colourOf(const Spectral& share) const {
  Vec3 sum(0.0);
  for (std::size_t b = 0; b < kBands; ++b) sum += share[b] * sunlight[b];
  return sum;
}

const LightBands& sunBands() {
  static const LightBands bands = makeSunBands();
  return bands;
}

LightBands oneWavelength(double wavelength) {
  LightBands bands{};
  bands.wavelength.fill(wavelength);
  bands.sunlight.fill(Vec3(1.0 / kBands));
  return bands;
}

AirSpectrum::AirSpectrum(const Atmosphere& air, const LightBands& bands, ForwardLight forward)
    : rayleigh(), ozone(), aerosol(), scattering() {
  const AerosolSettings& settings = air.settings().aerosol;
  g = settings.g;
  const double goesOn = forward == ForwardLight::goesOn && g > 0.0 ? g * g : 0.0;
  g = (g - goesOn) / (1.0 - goesOn);
  for (std::size_t b = 0; b < kBands; ++b) {
    const OfAir depths = air.depths(bands.wavelength[b]);
    rayleigh[b] = depths.rayleigh;
    ozone[b] = depths.ozone;
    scattering[b] = (1.0 - goesOn) * settings.albedo * depths.aerosol;
    aerosol[b] = depths.aerosol - goesOn * settings.albedo * depths.aerosol;
  }
}

}  // namespace parhelion
