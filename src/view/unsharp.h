// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "view/display.h"

namespace parhelion {

struct UnsharpSettings {
  double amount = 3.0;   // of the detail added on top: 3 is the "300 %" of photo editors
  double radius = 20.0;  // pixels, standard deviation of the Gaussian
};

/// Unsharp mask: each component becomes c + amount (c - its Gaussian mean), cut off at black and white. In the values a
/// screen shows, so that the same numbers do the same to a photograph and to a developed simulation.
/// Throws std::invalid_argument for a radius that blurGaussian refuses.
void unsharp(Display& picture, const UnsharpSettings& settings);

}  // namespace parhelion
