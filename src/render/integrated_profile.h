// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"
#include "trace/scatter_profile.h"

namespace parhelion {

/// Light over the scattering angle without any ray: integrated over all orientations, as ScatterProfile has it.
struct IntegratedProfile {
  std::vector<ScatterProfile::Bin> bins;
  ScatterProfile::Summary summary;  // rays are 0; errors are to either side
  double filtered = 0.0;            // share of the light that leaves by paths that are not kept
  long directions = 0;              // of light in a crystal that were traced
  int patches = 0;                  // of such directions
  bool reached = true;              // the error aimed at
};

/// What keeps a scene's profile from being integrated, in one line; empty if nothing does.
std::string objectionToIntegral(const Scene& scene);

/// How a profile is to be integrated.
struct IntegralProfileSettings {
  int bins = 0;
  double from = 0.0, to = 0.0;  // rad
  double error = 0.01;          // aimed at for the root of the mean squared relative error of all bins
  bool detailed = false;        // whether the summary has way and orders, too
};

/// Integrates the light of a scene that has no objection. Throws std::invalid_argument for one that has.
IntegratedProfile integrateProfile(const Scene& scene, const IntegralProfileSettings& settings);

}  // namespace parhelion
