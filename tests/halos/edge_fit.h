// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "halos/experiment.h"

namespace parhelion {

struct EdgeFit {
  double position;  // of the edge, in the histogram's units
  double softness;  // half width over which the edge rises
  double step;      // light per bin that sets in at the edge
};

/// Fits the inner edge of a halo: a straight background, and from the edge on a step with a slope of its own. Least
/// squares in the four straight lines' parameters, the best of all positions in the histogram's middle half.
EdgeFit fitEdge(const Histogram& histogram);

/// The same for an edge smeared by a disc of unknown radius, up to `widest`: the step is the disc's covered share.
EdgeFit fitSoftEdge(const Histogram& histogram, double widest);

}  // namespace parhelion
