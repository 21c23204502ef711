// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "scene/scene.h"
#include "trace/path_ledger.h"

namespace parhelion {

/// Light by raypath without any ray: integrated over all orientations.
struct IntegratedPaths {
  PathLedger ledger;
  double error = 0.0;                   // the largest standard error of a path's share
  double filtered = 0.0, cutOff = 0.0;  // shares of the light that is intercepted
  long directions = 0;                  // of light in a crystal that were traced
  bool reached = false;                 // the error aimed at
};

/// What keeps the light of a scene's paths from being integrated, in one line; empty if nothing does.
std::string objectionToIntegratedPaths(const Scene& scene);

/// Integrates the light of a scene that has no objection, until the standard errors of all shares are at most so much.
/// The same bits for any number of threads. `cloud` is the scene's and must outlive the result. Throws
/// std::invalid_argument for a scene that has an objection, and as PathPlan does.
IntegratedPaths integratePaths(const Scene& scene, const Cloud& cloud, const PathLedgerScope& scope, double error);

}  // namespace parhelion
