// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <variant>
#include <vector>

namespace parhelion {

/// The phase function of Henyey & Greenstein 1941 with its mean cosine g, between -1 and 1.
struct HenyeyGreenstein {
  double g = 0.75;
};

/// A phase function by its values, linear between the angles, which grow from 0 to pi. Any unit will do.
struct PhaseTable {
  std::vector<double> angles;  // from the direction of the light, rad
  std::vector<double> values;  // not negative, and not all 0
};

using PhaseSettings = std::variant<HenyeyGreenstein, PhaseTable>;

/// Irregular crystals, which scatter all the light that they meet by a phase function and have no halos of their own.
struct HazeSettings {
  std::string name;
  double weight = 1.0;  // share of all crystal surface in the cloud, as PopulationSettings::weight
  PhaseSettings phase = HenyeyGreenstein{};
};

}  // namespace parhelion
