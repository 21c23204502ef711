// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

#include "trace/trace_settings.h"

namespace parhelion {

/// How a path goes on at a face.
struct PathRule {
  /// A path splits while it carries at least this share of its ray's light. Below, it goes one way as a whole, picked
  /// by chance. The mean does not depend on this share.
  double splitShare;
};

/// The rule of a mode. The share of one half makes the product of variance and time small; see docs/model.md.
inline PathRule pathRule(PathMode mode) {
  return {mode == PathMode::chance ? std::numeric_limits<double>::infinity() : 0.5};
}

// Thin plates and long columns hold light by total reflection for some thousand encounters. Light that is still inside
// after this many is given up and counted as cut off.
inline constexpr int kMostEncounters = 1'000'000;

// Light that leaves within this angle (rad) of its direction of arrival counts as undeviated. Rounding makes errors of
// 1e-15 per encounter, and no halo has light that is deviated by so little.
inline constexpr double kSameDirection = 1e-8;

}  // namespace parhelion
