// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace parhelion {

/// What a camera does with what lies below the horizon.
enum class Horizon { keep, cut };

/// The word for it in scene files and image attributes.
constexpr std::string_view nameOf(Horizon horizon) {
  switch (horizon) {
    case Horizon::keep:
      return "keep";
    case Horizon::cut:
      return "cut";
  }
  return {};
}

}  // namespace parhelion
