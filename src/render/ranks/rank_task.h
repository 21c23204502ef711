// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "render/measurement.h"
#include "trace/trace_settings.h"

namespace parhelion {

/// What all ranks trace together.
struct RankTask {
  std::string scene;  // TOML that alone gives the scene
  Measurement measurement;
  int threads = 0;  // of each rank; 0: its share of its machine's processors
  Simd simd = Simd::automatic;
};

/// A task as a message to other ranks, and back. The latter throws std::runtime_error for a task of a program whose
/// numerics are others.
std::string textOf(const RankTask& task);
RankTask taskFromText(const std::string& text);

}  // namespace parhelion
