// SPDX-License-Identifier: Apache-2.0
#include "sky/confidence.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <glm/geometric.hpp>

#include "math/portable.h"
#include "picture/colour_space.h"
#include "sky/radiance.h"

namespace parhelion {
namespace {

constexpr double kSure = 0.01;  // relative standard error that is white; 1 is black

/// The expected square of a pixel's error; not finite where its parts are not.
double errorSquare(const std::vector<float>& variance, const std::vector<float>* bias, std::size_t pixel) {
  const double b = bias != nullptr ? static_cast<double>((*bias)[pixel]) : 0.0;
  return static_cast<double>(variance[pixel]) + b * b;
}

/// Grey from 0 to 1 of a relative variance, which is the square of the error.
double grey(double relativeVariance) {
  if (relativeVariance <= kSure * kSure) return 1.0;
  return std::max(0.0, 0.5 * portable::log(relativeVariance) / portable::log(kSure));
}

}  // namespace

Preview confidence(const Image& sky) {
  const auto [red, green, blue] = sky.rgb();
  const std::vector<float>* variance = sky.find(kVarianceChannel);
  if (variance == nullptr) throw std::invalid_argument("the image has no variance");
  const std::vector<float>* bias = sky.find(kBiasChannel);
  Preview preview{sky.width, sky.height, std::vector<std::uint8_t>(3 * sky.pixels()), 0};
  for (std::size_t i = 0; i < sky.pixels(); ++i) {
    const double y = glm::dot(kRec709Luminance, Vec3{(*red)[i], (*green)[i], (*blue)[i]});
    const double square = errorSquare(*variance, bias, i), relative = square / (y * y);
    if (!std::isfinite(y) || !std::isfinite(square)) ++preview.badPixels;
    // A negative luminance has no relative error, and a hopeless one may not be finite.
    const double g = y > 0.0 && std::isfinite(y) && std::isfinite(relative) ? grey(relative) : 0.0;
    std::fill_n(preview.rgb.begin() + static_cast<std::ptrdiff_t>(3 * i), 3,
                static_cast<std::uint8_t>(std::lround(255.0 * g)));
  }
  return preview;
}

}  // namespace parhelion
