// SPDX-License-Identifier: Apache-2.0
#include "trace/cloud.h"

#include <algorithm>
#include <stdexcept>

#include <glm/matrix.hpp>

#include "optics/ice.h"

namespace parhelion {

namespace {

/// A number in (0, 1) for each bundle: the golden ratio's multiples fill the interval evenly over any run of
/// consecutive bundles, in integers so that no digits are lost at high indices.
double goldenQuantile(std::uint64_t seed, std::uint64_t bundle) {
  constexpr std::uint64_t kGolden = 0x9E3779B97F4A7C15;  // 2^64 / golden ratio
  const auto start =
      philox4x32({0, 0, 0, 0}, {static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)});
  return toUnitInterval((std::uint64_t{start[1]} << 32 | start[0]) + bundle * kGolden);
}

}  // namespace

Cloud::Cloud(const SunSettings& sun, const IceSettings& ice, std::span<const PopulationSettings> populations)
    : sun_(sun), spectrum_(sun.spectrum), ice_(ice), populations_(populations.begin(), populations.end()) {
  // Any bound gives the right distribution; one that the pilot sample never exceeds wastes few proposals and leaves
  // nearly all rays with weight 1.
  constexpr int kPilot = 4096;
  double total = 0.0;
  for (int p = 0; p < static_cast<int>(populations_.size()); ++p) {
    double bound = 0.0;
    for (int i = 0; i < kPilot; ++i) {
      RandomStream random(static_cast<std::uint64_t>(p), i, RandomPurpose::pilot);
      bound = std::max(bound, propose(p, random).interception);
    }
    bound_.push_back(bound);
    total += populations_[p].weight() * bound;
    cumulative_.push_back(total);
  }
  if (!(total > 0.0)) throw std::invalid_argument("no population has any weight");
  for (double& c : cumulative_) c /= total;
}

Cloud::Proposal Cloud::propose(int population, RandomStream& random) const {
  const Population& kind = populations_[population];
  Proposal p;
  p.population = population;
  const double u1 = random.next(), u2 = random.next(), u3 = random.next();
  p.crystalToWorld = kind.orientation(u1, u2, u3);
  p.crystal = kind.crystal(random.next());
  p.lightDirWorld = -sun_.toCentre();
  if (!sun_.isPoint()) {
    const double v1 = random.next(), v2 = random.next();
    p.lightDirWorld = -sun_.toPoint(v1, v2);
  }
  p.lightDirCrystal = glm::transpose(p.crystalToWorld) * p.lightDirWorld;
  p.shadows = shadowsOf(p.crystal, p.lightDirCrystal);
  p.interception = p.shadows.total / p.crystal.surface();
  return p;
}

IncidentRay Cloud::incidentRay(std::uint64_t seed, std::uint64_t index) const {
  const std::uint64_t bundle = index / bundleSize();
  RandomStream random(seed, bundle, RandomPurpose::incidence);
  while (true) {
    // Propose a population by weight * bound and a crystal of it, accept in proportion to interception / bound. Where
    // the interception exceeds the bound the ray carries the excess as weight, so the result never depends on the
    // bound.
    const double u = random.next();
    const auto chosen = std::upper_bound(cumulative_.begin(), cumulative_.end(), u);
    const int population =
        static_cast<int>(std::min(chosen - cumulative_.begin(), std::ptrdiff_t(cumulative_.size()) - 1));
    const Proposal p = propose(population, random);
    const double ratio = p.interception / bound_[population];
    if (random.next() >= ratio) continue;

    IncidentRay ray;
    ray.bundle = bundle;
    ray.population = population;
    ray.crystal = p.crystal;
    ray.crystalToWorld = p.crystalToWorld;
    ray.lightDirWorld = p.lightDirWorld;
    ray.lightDirCrystal = p.lightDirCrystal;
    ray.projectedArea = p.shadows.total;
    const double v1 = random.next(), v2 = random.next(), v3 = random.next();
    ray.entry = sampleEntry(p.crystal, p.shadows, v1, v2, v3);
    ray.weight = std::max(1.0, ratio);
    setWavelength(ray, seed, index);
    return ray;
  }
}

IncidentRay Cloud::sibling(const IncidentRay& ray, std::uint64_t seed, std::uint64_t index) const {
  IncidentRay other = ray;
  setWavelength(other, seed, index);
  return other;
}

void Cloud::setWavelength(IncidentRay& ray, std::uint64_t seed, std::uint64_t index) const {
  ray.index = index;
  if (bundleSize() == 1) {
    ray.light = spectrum_.lines().front();
    ray.iceIndex = refractiveIndex(ice_, ray.light.wavelength, ray.bundle);
    return;
  }
  // The wavelengths of a bundle stand at equal distances in the spectrum, from a start that differs between bundles.
  const auto member = static_cast<double>(index % bundleSize());
  ray.light = spectrum_.sample((member + goldenQuantile(seed, ray.bundle)) / bundleSize());
  ray.iceIndex = refractiveIndex(ice_, ray.light.wavelength, ray.bundle);
}

}  // namespace parhelion
