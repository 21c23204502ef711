// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <variant>

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

}  // namespace parhelion
