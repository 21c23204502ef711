// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <variant>

#include "optics/light_settings.h"

namespace parhelion {

/// Warren & Brandt's table, kIceIndex of optics/tables.h.
struct IceTable {};

/// What is known of a material.
struct MaterialFacts {
  std::variant<IceTable, SellmeierIndex, CauchyIndex> index;
  double from, to;          // nm, where that was measured; beyond, the ends' values are taken
  std::string_view source;  // for people
};

const MaterialFacts& factsOf(Material material);

}  // namespace parhelion
