// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "recon/reconstruct.h"
#include "recon_plan.h"
#include "stopwatch.h"

namespace parhelion::bench {

/// A method with the settings it is tried with.
struct Contender {
  std::string id;        // as charts find it
  std::string label;     // for people
  std::string settings;  // what differs from the defaults, "key=value key=value"
  ReconSettings method;

  std::string methodName() const;
};

/// All of them, from plain to adaptive.
std::span<const Contender> contenders();

struct TimedSky {
  ReconstructedSky sky;
  Timing timing;  // of reconstruct() alone
};

/// Reconstructs once to warm up, and takes the best time of three more; slow methods and quick plans once.
TimedSky timedSky(const Plan& plan, const Tally& tally, const ReconSettings& method);

}  // namespace parhelion::bench
