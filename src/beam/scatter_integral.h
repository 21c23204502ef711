// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "beam/scatter_scene.h"

namespace parhelion {

/// Patches of directions that are made at a time: as many hold their bins in memory, three numbers for each. A section
/// that is not regular has some more in the beginning.
inline constexpr std::size_t kPatchesAtATime = 64;

/// How finely it is integrated.
struct ScatterAccuracy {
  /// Aimed at for the root of the mean squared relative error of all bins; where paths are wanted, of those with light.
  double error = 0.01;
  /// Of all light: what is below it is not cut up any more (PrismTracer).
  double cutShare = 1e-5;
  /// Whether the way inside and the light by order are wanted, too.
  bool detailed = false;
};

/// Light over the scattering angle, integrated over all orientations. Bits do not depend on threads.
struct ScatterIntegral {
  std::vector<double> light;  // of each bin, as a share of all that is intercepted; undeviated light apart
  std::vector<double> error;  // standard error of each, from what a mesh of half as many nodes differs by
  ScatterTotals totals;       // shares of all intercepted light; that itself over the mean shadow that a convex body
                              // has, a quarter of its surface (Cauchy)
  double gError = 0.0, pathError = 0.0;  // standard errors of the mean cosine and of the way
  int patches = 0;
  long directions = 0;  // traced
  bool reached = true;  // the accuracy aimed at
};

/// Integrates over `bins` bins from `from` to `to` (rad).
ScatterIntegral integrateScatter(const ScatterScene& scene, const ScatterAccuracy& accuracy, int bins, double from,
                                 double to);

}  // namespace parhelion
