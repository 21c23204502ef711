// SPDX-License-Identifier: Apache-2.0
#pragma once

// Words of scene files that no module below has.

#include <string_view>

#include "math/names.h"
#include "scene/scene.h"

namespace parhelion {

/// The words for orientations that need no more than a tilt and a roll.
enum class OrientationName { random, plate, column, parry, lowitz };

constexpr std::string_view nameOf(OrientationName value) {
  switch (value) {
    case OrientationName::random:
      return "random";
    case OrientationName::plate:
      return "plate";
    case OrientationName::column:
      return "column";
    case OrientationName::parry:
      return "parry";
    case OrientationName::lowitz:
      return "lowitz";
  }
  return {};
}

}  // namespace parhelion
