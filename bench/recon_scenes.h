// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "recon_plan.h"
#include "scene/parse_scene.h"
#include "sky/tally.h"

namespace parhelion::bench {

/// A sky to reconstruct: light of one wavelength in hits of equal weight, on 512 x 512 pixels.
struct BenchScene {
  std::string name;
  std::string file;                    // from the root of the repository
  std::vector<std::string> overrides;  // beyond those that all have
  std::uint64_t referenceRays;

  LoadedScene load(const Plan& plan, std::uint64_t rays, std::uint64_t seed) const;
};

/// Those of the plan; the first is the one that settings are swept on.
std::span<const BenchScene> benchScenes(const Plan& plan);

/// The tally of so many rays, from disk if it is there and of the same scene, else traced and kept there.
Tally sceneTally(const Plan& plan, const BenchScene& scene, std::uint64_t rays, std::uint64_t seed);

/// Shares no ray with the tallies of seeds below 1000.
Tally referenceTally(const Plan& plan, const BenchScene& scene);

std::uint64_t referenceRays(const Plan& plan, const BenchScene& scene);

/// Rays a second of the tracer for this scene, measured.
double tracingSpeed(const Plan& plan, const BenchScene& scene);

}  // namespace parhelion::bench
