// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <variant>

#include "trace/trace_settings.h"

namespace parhelion {

/// The scene's light through its camera.
struct SkyMeasurement {};
/// Its light over the whole sphere; see SkyMap.
struct MapMeasurement {
  int binsPerHalfTurn = 0;
};
/// Its light over the scattering angle (rad); see ScatterProfile.
struct ProfileMeasurement {
  int bins = 0;
  double from = 0.0, to = 0.0;
};
using Measurement = std::variant<SkyMeasurement, MapMeasurement, ProfileMeasurement>;

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
