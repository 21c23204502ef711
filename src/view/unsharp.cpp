// SPDX-License-Identifier: Apache-2.0
#include "view/unsharp.h"

#include <algorithm>

#include "view/gaussian_blur.h"

namespace parhelion {

void unsharp(Display& picture, const UnsharpSettings& settings) {
  for (std::vector<float>& plane : picture.planes) {
    std::vector<float> mean = plane;
    blurGaussian(mean, picture.width, picture.height, settings.radius);
    for (std::size_t i = 0; i < plane.size(); ++i) {
      const double c = plane[i];
      plane[i] = static_cast<float>(std::clamp(c + settings.amount * (c - mean[i]), 0.0, 1.0));
    }
  }
}

}  // namespace parhelion
