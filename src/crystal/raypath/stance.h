// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

#include "crystal/population.h"

namespace parhelion {

/// How crystals stand in the air, by which halos are told apart.
enum class Stance { random, plate, column, parry, lowitz };

constexpr std::string_view nameOf(Stance value) {
  switch (value) {
    case Stance::random:
      return "random";
    case Stance::plate:
      return "plate";
    case Stance::column:
      return "column";
    case Stance::parry:
      return "parry";
    case Stance::lowitz:
      return "lowitz";
  }
  return {};
}

/// How most crystals of a population stand; none where that has no name. What makes Lowitz crystals of plates that tilt
/// far is that the axis through two opposite edges stays level.
std::optional<Stance> stanceOf(const Population& population);

}  // namespace parhelion
