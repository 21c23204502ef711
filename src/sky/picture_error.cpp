// SPDX-License-Identifier: Apache-2.0
#include "sky/picture_error.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <glm/geometric.hpp>

#include "picture/colour_space.h"
#include "sky/radiance.h"

namespace parhelion {

double pictureError(const Image& sky, std::span<const double> solidAngles) {
  const auto [red, green, blue] = sky.rgb();
  const std::vector<float>*variance = sky.find(kVarianceChannel), *bias = sky.find(kBiasChannel);
  if (!variance) throw std::invalid_argument("the picture has no variance");
  if (solidAngles.size() != sky.pixels()) throw std::invalid_argument("the picture has another number of pixels");
  double errors = 0.0, light = 0.0;
  for (std::size_t i = 0; i < sky.pixels(); ++i) {
    const double luminance = glm::dot(kRec709Luminance, Vec3{(*red)[i], (*green)[i], (*blue)[i]});
    const double b = bias ? static_cast<double>((*bias)[i]) : 0.0;
    const double error = std::sqrt(static_cast<double>((*variance)[i]) + b * b);
    if (!std::isfinite(luminance) || !std::isfinite(error)) continue;
    errors += solidAngles[i] * error;
    light += solidAngles[i] * luminance;
  }
  return light > 0.0 ? errors / light : std::numeric_limits<double>::infinity();
}

}  // namespace parhelion
