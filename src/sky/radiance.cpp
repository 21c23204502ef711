// SPDX-License-Identifier: Apache-2.0
#include "sky/radiance.h"

#include <cmath>

#include "picture/colour_space.h"
#include "sky/camera.h"

namespace parhelion {
namespace {

/// The root of the mean square of what one hit brought to a pixel; 0 without hits.
double typicalDepositOf(const Tally& tally) {
  double squares = 0.0, hits = 0.0;
  for (int pixel = 0; pixel < tally.pixels(); ++pixel) {
    squares += tally.squares(pixel);
    hits += static_cast<double>(tally.hits(pixel));
  }
  return hits > 0.0 ? std::sqrt(squares / hits) : 0.0;
}

}  // namespace

Image plainRadiance(const Tally& tally) {
  Image image{tally.width(), tally.height(), {}};
  for (const char* name : {"R", "G", "B", kVarianceChannel}) image.add(name);
  const double intercepted = tally.info.interceptedLight();
  if (intercepted <= 0.0) return image;

  const Mat3 toRgb = xyzToRec709(tally.info.white);
  const std::vector<double> solidAngles = Camera(tally.info.camera).solidAngles();
  const double typicalDeposit = typicalDepositOf(tally);
  for (int pixel = 0; pixel < tally.pixels(); ++pixel) {
    const auto i = static_cast<std::size_t>(pixel);
    if (solidAngles[i] <= 0.0) continue;
    const double perLight = 1.0 / (intercepted * solidAngles[i]);
    const Vec3 rgb = perLight * (tally.colours() == 1 ? Vec3(tally.luminance(pixel)) : toRgb * tally.xyz(pixel));
    const double error = perLight * (tally.hits(pixel) > 0 ? tally.luminanceError(pixel) : typicalDeposit);
    image.channels[0].samples[i] = static_cast<float>(rgb.x);
    image.channels[1].samples[i] = static_cast<float>(rgb.y);
    image.channels[2].samples[i] = static_cast<float>(rgb.z);
    image.channels[3].samples[i] = static_cast<float>(error * error);
  }
  return image;
}

}  // namespace parhelion
