// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "recon/compare.h"
#include "recon_methods.h"

namespace parhelion::bench {

/// How one method did on one tally.
struct Trial {
  const Contender* contender;
  std::uint64_t rays;
  Timing timing;
  Comparison error;
};

/// How one method did on the tallies of one scene and one number of rays: means.
struct Summary {
  std::string scene;
  const Contender* contender;
  std::uint64_t rays;
  double relMse = 0.0, logMse = 0.0, ssim = 0.0, energyError = 0.0;
  Timing timing;
  double tracingSeconds = 0.0;  // that the rays take
  /// How many times as many rays the plain radiance would need for the same relMSE, which falls as 1/rays for it.
  double raysSaved = 0.0;
};

/// By method, then by number of rays.
std::vector<Summary> summarise(const std::string& scene, const std::vector<Trial>& trials,
                               const std::vector<std::uint64_t>& rayCounts, double tracingSpeed);

/// Writes recon_summary.csv, and recon_table.md for the documentation.
void writeSummaries(const Plan& plan, const std::vector<Summary>& summaries);

}  // namespace parhelion::bench
