// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "crystal/population.h"
#include "math/random.h"
#include "optics/spectrum.h"
#include "optics/sun.h"

namespace parhelion {

/// One ray of sunlight as it meets a crystal.
struct IncidentRay {
  std::uint64_t index = 0;
  std::uint64_t bundle = 0;  // of rays that differ in wavelength alone
  int population = 0;
  Crystal crystal{};
  Mat3 crystalToWorld{1.0};
  Vec3 lightDirWorld{};        // unit, from the sun's disc toward the crystal
  Vec3 lightDirCrystal{};      // the same in the crystal's frame
  EntryPoint entry{};          // crystal frame
  double projectedArea = 0.0;  // of this crystal in this orientation, crystal units squared
  SpectralSample light;
  double iceIndex = 1.31;  // refractive index at this wavelength
  double weight = 1.0;     // intercepted light this ray stands for; nearly always 1
};

/// Sun, ice and crystals: everything a ray's start is drawn from. Immutable; safe to use from many threads.
class Cloud {
 public:
  /// Throws std::invalid_argument when no population has any weight.
  Cloud(const SunSettings& sun, const IceSettings& ice, std::span<const PopulationSettings> populations);

  /// Rays k * bundleSize() ... (k + 1) * bundleSize() - 1 share everything but their wavelength; see Spectrum.
  int bundleSize() const { return spectrum_.bundleSize(); }

  /// The ray `index` of the sequence `seed`: a pure function of its arguments. Rays are distributed like the light that
  /// the crystals intercept: each crystal in proportion to its projected area in its own orientation.
  IncidentRay incidentRay(std::uint64_t seed, std::uint64_t index) const;

  /// Ray `index` from any other ray of its bundle; incidentRay(seed, index) without drawing anew.
  IncidentRay sibling(const IncidentRay& ray, std::uint64_t seed, std::uint64_t index) const;

  const Sun& sun() const { return sun_; }
  const Spectrum& spectrum() const { return spectrum_; }
  const std::vector<Population>& populations() const { return populations_; }

 private:
  /// A crystal on its way to be accepted or not.
  struct Proposal {
    int population;
    Crystal crystal;
    Mat3 crystalToWorld;
    Vec3 lightDirWorld, lightDirCrystal;
    Shadows shadows;
    double interception;  // area / surface: light intercepted per unit of surface
  };
  void setWavelength(IncidentRay& ray, std::uint64_t seed, std::uint64_t index) const;
  Proposal propose(int population, RandomStream& random) const;

  Sun sun_;
  Spectrum spectrum_;
  IceSettings ice_;
  std::vector<Population> populations_;
  std::vector<double> bound_;       // of each population's interception; see incidentRay()
  std::vector<double> cumulative_;  // of weight * bound, up to 1
};

}  // namespace parhelion
