// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "crystal/population.h"
#include "crystal/span.h"
#include "math/names.h"
#include "optics/ice.h"
#include "optics/spectrum.h"
#include "optics/sun.h"
#include "trace/concave_crystal.h"
#include "trace/crystal_optics.h"
#include "trace/incidence.h"
#include "trace/ray_queue.h"
#include "trace/trace_settings.h"

namespace parhelion {

/// Sun, ice and crystals: everything a ray's start is drawn from. Immutable; safe to use from many threads.
class Cloud {
 public:
  /// Rays are shared out among the populations as their light is, times a factor for each population in `favours`,
  /// which are positive; empty: all alike. A ray of a population that gets more of them weighs less. Throws
  /// std::invalid_argument when no population has any weight.
  Cloud(const SunSettings& sun, const IceSettings& ice, std::span<const PopulationSettings> populations,
        std::vector<double> favours = {});

  /// Rays k * bundleSize() ... (k + 1) * bundleSize() - 1 share everything but their wavelength; see Spectrum.
  int bundleSize() const { return spectrum_.bundleSize(); }

  /// What the rays of a population are drawn from; valid as long as the cloud.
  IncidenceTable incidence(int population, Sampler sampler) const;

  /// The crystal of a population for lanes; of one whose shapes are spread it is a typical one, which no ray meets.
  const FaceTable& faces(int population) const { return faces_[population]; }

  /// What is not ideal about a population's crystals.
  const CrystalOptics& optics(int population) const { return optics_[population]; }

  /// The size of a population's crystal, where its shape is not spread and its size is known.
  const std::optional<CrystalSpan>& span(int population) const { return spans_[population]; }

  /// Puts what crystals that are not ideal do to each ray into a queue of a population whose crystal is so large.
  void putOptics(int population, const std::optional<CrystalSpan>& span, std::uint64_t seed, RayQueue& queue) const;

  /// A population's crystal where it is not convex; null for convex ones.
  const ConcaveCrystal* concave(int population) const { return concave_[population].get(); }

  /// Whether there are populations whose shapes are spread. So many bundles in a row, counted from the run's first,
  /// meet the same crystal of such a population.
  bool hasSpreadShapes() const { return hasSpreadShapes_; }
  int bundlesPerShape() const;

  /// Shares of the populations among the crystals proposed, added up to 1.
  const std::vector<double>& shares(Sampler sampler) const { return pilot_[static_cast<int>(sampler)].cumulative; }

  /// The light that each population intercepts, as shares of all; as a pilot sample has it.
  const std::vector<double>& lightShares() const { return lightShares_; }

  /// The wavelength of a member of a bundle.
  SpectralSample light(std::uint64_t seed, std::uint64_t bundle, int member) const;

  /// The refractive index that a bundle's ray of a wavelength (nm) meets.
  double iceIndex(double wavelength, std::uint64_t bundle) const { return refractiveIndex(ice_, wavelength, bundle); }

  /// Whether the light and the ice of a member are the same in all bundles.
  bool hasFixedLight() const { return !spectrum_.lines().empty() && !differsByBundle(ice_); }

  const Sun& sun() const { return sun_; }
  const Spectrum& spectrum() const { return spectrum_; }
  const std::vector<Population>& populations() const { return populations_; }

 private:
  /// How crystals are proposed: each population in proportion to weight * bound.
  struct Pilot {
    std::vector<double> bound;       // of a population's interception; see IncidenceTable
    std::vector<double> cumulative;  // of weight * bound, up to 1
  };
  void addPilot(Pilot& pilot, const std::vector<double>& bounds) const;
  void shareOut(const std::vector<double>& meanInterceptions);

  Sun sun_;
  std::unique_ptr<const SunDisc> disc_;  // none for a point sun
  Spectrum spectrum_;
  IceSettings ice_;
  std::vector<Population> populations_;
  std::vector<FaceTable> faces_;
  std::vector<std::unique_ptr<const ConcaveCrystal>> concave_;  // by population
  std::vector<CrystalOptics> optics_;                           // likewise
  std::vector<std::optional<LengthSampler>> sizes_;             // um
  std::vector<std::optional<CrystalSpan>> spans_;
  bool hasSpreadShapes_ = false;
  std::array<Pilot, kNamesOf<Sampler>.size()> pilot_;        // by Sampler
  std::vector<double> favours_, lightPerRay_, lightShares_;  // by population
};

}  // namespace parhelion
