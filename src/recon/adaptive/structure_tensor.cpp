// SPDX-License-Identifier: Apache-2.0
#include "recon/adaptive/structure_tensor.h"

#include <algorithm>
#include <cmath>

#include "math/portable.h"
#include "parallel/loops.h"
#include "recon/integral_image.h"
#include "recon/kernel_variance.h"

namespace parhelion {
namespace {

constexpr double kMaxAspect = KernelBank::kMaxAspect;

struct Tensor {
  float xx = 0.0F, xy = 0.0F, yy = 0.0F;
  float noise = 0.0F;  // expected in xx and in yy
};

/// log(density + a little), so that noise and arcs count alike in the bright and in the dark.
Raster<float> logDensity(const SkyPyramid& sky, const Raster<Light<1>>& density, float little) {
  Raster<float> result(sky.width(), sky.height());
  forRows(sky.height(), [&](int y) {
    for (int x = 0; x < sky.width(); ++x)
      result.at(x, y) = static_cast<float>(portable::log(static_cast<double>(density.at(x, y)[0] + little)));
  });
  return result;
}

double meanOverSky(const SkyPyramid& sky, const Raster<Light<1>>& density) {
  const double sum = sumOverRows(sky.height(), [&](int y) {
    double row = 0.0;
    for (int x = 0; x < sky.width(); ++x) row += static_cast<double>(density.at(x, y)[0]);
    return row;
  });
  return sum / static_cast<double>(sky.skyPixels());
}

/// Products of the slopes; zero at the border, where there are none. The unit of length is such that a circle in the
/// sky is round and a pixel has the area 1.
Raster<Tensor> tensors(const SkyPyramid& sky, const Raster<Light<1>>& density, double hits) {
  constexpr double kLittle = 0.02;  // of the mean
  const float little = static_cast<float>(kLittle * meanOverSky(sky, density));
  const Raster<float> log = logDensity(sky, density, little);
  Raster<Tensor> result(sky.width(), sky.height());
  forRows(sky.height(), [&](int y) {
    const float widthUnit = std::sqrt(sky.stretch(y));
    for (int x = 0; x < sky.width(); ++x) {
      if (sky.pixels().border.at(x, y) < 2) continue;
      const float gx = 0.5F * (log.at(x + 1, y) - log.at(x - 1, y)) * widthUnit;
      const float gy = 0.5F * (log.at(x, y + 1) - log.at(x, y - 1)) / widthUnit;
      // The slope of a kernel of variance s has the square integral 0.096 / (pi s^2), the noise of a density that many
      // times the density.
      const float here = density.at(x, y)[0];
      const float perPixel = here * sky.wholeOmega().at(x, y);
      const double s = static_cast<double>(kernelVariance(hits, perPixel));
      const float damping = here / (here + little);
      const float noise = perPixel > 0.0F ? static_cast<float>(0.096 / (kPi * s * s)) / perPixel : 0.0F;
      result.at(x, y) = {gx * gx, gx * gy, gy * gy, damping * damping * noise};
    }
  });
  return result;
}

/// Mean slopes' eigenvalues without noise to a shape; `variance` is the pilot kernel's.
KernelShape shapeOf(const Tensor& t, double variance) {
  const double half = 0.5 * static_cast<double>(t.xx + t.yy);
  const double c = 0.5 * static_cast<double>(t.xx - t.yy), s = static_cast<double>(t.xy);
  const double split = std::sqrt(c * c + s * s);
  if (split <= 0.0) return {};
  // Aspects follow the slopes' squares over the kernel's width, times this; half or double changes little.
  constexpr double kContrast = 128.0;
  const double noise = static_cast<double>(t.noise);
  const double across = std::max(half + split - noise, 0.0), along = std::max(half - split - noise, 0.0);
  const double ratio = (1.0 + kContrast * across * variance) / (1.0 + kContrast * along * variance);
  const double aspect = std::clamp(std::sqrt(ratio), 1.0, kMaxAspect);
  // The long axis is perpendicular to the steepest slope.
  const double size = -0.5 * (aspect - 1.0 / aspect) / split;
  return {static_cast<float>(size * c), static_cast<float>(size * s)};
}

}  // namespace

Raster<KernelShape> kernelShapes(const SkyPyramid& sky, const Raster<Light<1>>& density, double hits) {
  const Raster<Tensor> tensor = tensors(sky, density, hits);
  const int width = sky.width(), height = sky.height();
  const auto sums = [&](float Tensor::*part) {
    return IntegralImage<double>(width, height, [&, part](int x, int y) { return tensor.at(x, y).*part; });
  };
  const auto xx = sums(&Tensor::xx), xy = sums(&Tensor::xy), yy = sums(&Tensor::yy), noise = sums(&Tensor::noise);
  const IntegralImage<double> pixels(width, height, [&](int x, int y) { return sky.pixels().border.at(x, y) >= 2; });

  constexpr double kWindow = 6.0;  // standard deviations of the pilot's kernels
  Raster<KernelShape> shapes(width, height);
  forRows(height, [&](int y) {
    for (int x = 0; x < width; ++x) {
      if (sky.pixels().omega.at(x, y) <= 0.0F) continue;
      const float perPixel = density.at(x, y)[0] * sky.wholeOmega().at(x, y);
      const double variance = static_cast<double>(kernelVariance(hits, perPixel));
      // A square of half side r has the variance r^2 / 3.
      const int r = std::max(2, static_cast<int>(std::min(kWindow * std::sqrt(3.0 * variance), kBeyondAnyPicture)));
      const double count = pixels.square(x, y, r);
      if (count <= 0.0) {
        shapes.at(x, y) = KernelShape{}.stretched(sky.stretch(y));
        continue;
      }
      const auto mean = [&](const IntegralImage<double>& sum) {
        return static_cast<float>(sum.square(x, y, r) / count);
      };
      shapes.at(x, y) = shapeOf({mean(xx), mean(xy), mean(yy), mean(noise)}, variance).stretched(sky.stretch(y));
    }
  });
  return shapes;
}

}  // namespace parhelion
