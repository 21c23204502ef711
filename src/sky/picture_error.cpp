// SPDX-License-Identifier: Apache-2.0
#include "sky/picture_error.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <glm/geometric.hpp>

#include "picture/colour_space.h"
#include "sky/camera.h"
#include "sky/radiance.h"

namespace parhelion {
namespace {

/// The luminance of a picture's pixels and the error that is expected of it.
class Luminance {
 public:
  explicit Luminance(const Image& image)
      : rgb_(image.rgb()), variance_(image.find(kVarianceChannel)), bias_(image.find(kBiasChannel)) {
    if (variance_ == nullptr) throw std::invalid_argument("the picture has no variance");
  }

  double at(std::size_t i) const {
    return glm::dot(kRec709Luminance, Vec3{(*rgb_[0])[i], (*rgb_[1])[i], (*rgb_[2])[i]});
  }
  double error(std::size_t i) const {
    const double bias = bias_ ? static_cast<double>((*bias_)[i]) : 0.0;
    return std::sqrt(static_cast<double>((*variance_)[i]) + bias * bias);
  }

 private:
  std::array<const std::vector<float>*, 3> rgb_;
  const std::vector<float>*variance_, *bias_;
};

}  // namespace

double pictureError(const Image& sky, const Tally& tally) {
  if (sky.width != tally.width() || sky.height != tally.height())
    throw std::invalid_argument("the picture has another size than the tally");
  const Image plainImage = plainRadiance(tally);
  const Luminance picture(sky), plain(plainImage);
  const std::vector<double> solidAngles = Camera(tally.info.camera).solidAngles();
  double errors = 0.0, light = 0.0;
  for (std::size_t i = 0; i < sky.pixels(); ++i) {
    const double luminance = picture.at(i), expected = picture.error(i);
    const double error = std::min(expected, std::abs(luminance - plain.at(i)) + plain.error(i));
    if (!std::isfinite(luminance) || !std::isfinite(error)) continue;
    errors += solidAngles[i] * error;
    light += solidAngles[i] * luminance;
  }
  return light > 0.0 ? errors / light : std::numeric_limits<double>::infinity();
}

double pictureLight(const Image& sky, const CameraSettings& camera) {
  const auto rgb = sky.rgb();
  const std::vector<double> solidAngles = Camera(camera).solidAngles();
  double light = 0.0;
  for (std::size_t i = 0; i < solidAngles.size(); ++i) {
    const double luminance = glm::dot(kRec709Luminance, Vec3{(*rgb[0])[i], (*rgb[1])[i], (*rgb[2])[i]});
    if (std::isfinite(luminance)) light += solidAngles[i] * luminance;
  }
  return light;
}

double plainError(const Tally& tally) { return pictureError(plainRadiance(tally), tally); }

}  // namespace parhelion
