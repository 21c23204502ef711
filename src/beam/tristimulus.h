// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

namespace parhelion {

/// CIE XYZ of light. Where colours do not matter, all light counts as (1, 1, 1), and its sums are those of Y.
using Tristimulus = std::array<double, 3>;

/// An index, and the colour of the light that meets it.
struct IndexColour {
  double index;
  Tristimulus xyz;
};

}  // namespace parhelion
