// SPDX-License-Identifier: Apache-2.0
#include "sky/draw_sun.h"

#include <algorithm>
#include <cmath>

#include "math/rotation.h"

namespace parhelion {

namespace {

// Samples across the sun's disc, so that a disc smaller than a pixel still brings its light to about a thousandth.
constexpr double kSamplesAcrossDisc = 64.0;
constexpr int kMostSamplesAcrossPixel = 512;

/// Mean radiance of the disc over one pixel, by a grid of sub-pixels.
double meanRadiance(const Camera& camera, const Sun& sun, int x, int y, int samples) {
  double sum = 0.0;
  int onSky = 0;
  for (int j = 0; j < samples; ++j)
    for (int i = 0; i < samples; ++i) {
      const auto toSky = camera.toSky(Vec2(x + (i + 0.5) / samples, y + (j + 0.5) / samples));
      if (!toSky) continue;
      ++onSky;
      sum += sun.radiance(angleBetween(*toSky, sun.toCentre()));
    }
  return onSky > 0 ? sum / onSky : 0.0;
}

void addToPixel(Image& image, int pixel, double radiance) {
  for (Channel& channel : image.channels)
    if (channel.name == "R" || channel.name == "G" || channel.name == "B")
      channel.samples[pixel] += static_cast<float>(radiance);
}

}  // namespace

void drawUndeviatedSun(Image& image, const Camera& camera, const Sun& sun, double share) {
  if (sun.isPoint()) {
    if (const auto pixel = camera.pixelAt(sun.toCentre()))
      addToPixel(image, *pixel, share / camera.solidAngle(*pixel % camera.width(), *pixel / camera.width()));
    return;
  }
  for (int y = 0; y < camera.height(); ++y)
    for (int x = 0; x < camera.width(); ++x) {
      const auto centre = camera.toSky(Vec2(x + 0.5, y + 0.5));
      if (!centre) continue;
      // A pixel's corner is nearer to its centre than twice the side of a square of its solid angle, unless it is
      // stretched; four times leaves room for that.
      const double side = std::sqrt(camera.solidAngle(x, y));
      const double reach = 0.5 * sun.diameter() + 4.0 * side;
      if (angleBetween(*centre, sun.toCentre()) > reach) continue;
      const int samples = std::clamp(static_cast<int>(std::ceil(kSamplesAcrossDisc * side / sun.diameter())), 4,
                                     kMostSamplesAcrossPixel);
      if (const double radiance = meanRadiance(camera, sun, x, y, samples); radiance > 0.0)
        addToPixel(image, y * camera.width() + x, share * radiance);
    }
}

}  // namespace parhelion
