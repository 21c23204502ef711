// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sky/tally.h"
#include "trace/traced_rays.h"

namespace parhelion {

/// The light that crystals intercept, and of that the light that goes straight on; exact sums.
class InterceptedLight {
 public:
  explicit InterceptedLight(const Tally& tally) : perWhite_(tally.perWhite()) {}

  void add(const TracedRays& traced);

  /// Adds it to a tally's totals, as many times as a ray counts there.
  void addTo(TallyInfo& info) const;
  void clear();

 private:
  Vec3 perWhite_;
  LightTotal intercepted_, undeviated_;
  std::array<LightTotal, 3> xyz_;  // of `intercepted_`, over the white's
};

}  // namespace parhelion
