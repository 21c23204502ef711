// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sky/camera.h"

namespace parhelion {

/// The mean of f(toSky), a number or a vector, over the part of a pixel that shows sky: by a grid of so many points to
/// a side. 0 where none of them does.
template <class F>
auto meanOverPixel(const Camera& camera, int x, int y, int side, const F& f) {
  decltype(f(Vec3())) sum(0.0);
  int seen = 0;
  for (int j = 0; j < side; ++j)
    for (int i = 0; i < side; ++i)
      if (const auto toSky = camera.toSky({x + (i + 0.5) / side, y + (j + 0.5) / side})) {
        sum += f(*toSky);
        ++seen;
      }
  return seen > 0 ? sum / static_cast<double>(seen) : sum;
}

}  // namespace parhelion
