// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sky/tally.h"
#include "trace/traced_rays.h"

namespace parhelion {

/// The light that crystals intercept, and of that the light that goes straight on; exact sums.
class InterceptedLight {
 public:
  void add(const TracedRays& traced);

  /// Adds it `images` times to a tally's totals.
  void addTo(TallyInfo& info, int images) const;

 private:
  std::int64_t intercepted_ = 0, undeviated_ = 0;
};

}  // namespace parhelion
