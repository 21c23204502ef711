// SPDX-License-Identifier: Apache-2.0
#include "recon/published/gaussian.h"

#include <algorithm>
#include <cmath>

#include "math/portable.h"
#include "parallel/loops.h"
#include "recon/methods.h"
#include "recon/published/filter_size.h"

namespace parhelion {

namespace {

constexpr double kCut = 4.0;  // standard deviations at which the kernel ends: 6e-5 of it is beyond

// One axis of the convolution.
struct Axis {
  int side;
  bool wrap;
  int reach = 0;                // pixels to both sides
  std::vector<double> weights;  // of -reach to reach, not normalised

  Axis(int length, bool touches, double sigma) : side(length), wrap(touches) {
    // Round a torus a Gaussian as wide as itself is constant within 1e-8. Elsewhere no pixels are `side` apart.
    const double width = wrap ? std::min(sigma, static_cast<double>(side)) : sigma;
    const double cut = std::ceil(kCut * width);
    reach = static_cast<int>(wrap ? cut : std::min(cut, side - 1.0));
    for (int d = -reach; d <= reach; ++d) weights.push_back(portable::exp(-0.5 * d * d / (width * width)));
  }
};

Raster<double> convolveRows(const Raster<double>& in, const Axis& axis) {
  Raster<double> out(in.width(), in.height());
  const int width = in.width();
  forRows(in.height(), [&](int y) {
    // The row, continued beyond both edges.
    std::vector<double> line;
    for (int i = -axis.reach; i < width + axis.reach; ++i) {
      const bool inside = i >= 0 && i < width;
      line.push_back(inside ? in.at(i, y) : axis.wrap ? in.at(((i % width) + width) % width, y) : 0.0);
    }
    double* row = out.row(y);
    for (std::size_t t = 0; t < axis.weights.size(); ++t) {
      const double* shifted = line.data() + t;
      for (int x = 0; x < width; ++x) row[x] += axis.weights[t] * shifted[x];
    }
  });
  return out;
}

Raster<double> convolveColumns(const Raster<double>& in, const Axis& axis) {
  Raster<double> out(in.width(), in.height());
  const int height = in.height();
  forRows(height, [&](int y) {
    double* row = out.row(y);
    for (int d = -axis.reach; d <= axis.reach; ++d) {
      const int j = axis.wrap ? (((y + d) % height) + height) % height : y + d;
      if (j < 0 || j >= height) continue;
      const double weight = axis.weights[static_cast<std::size_t>(d + axis.reach)];
      const double* from = in.row(j);
      for (int x = 0; x < in.width(); ++x) row[x] += weight * from[x];
    }
  });
  return out;
}

}  // namespace

std::vector<Raster<double>> gaussianMeans(const HitMap& map, double sigma) {
  const Axis rows(map.width(), map.wrapX, sigma), columns(map.height(), map.wrapY, sigma);
  const Raster<double> sky = convolveColumns(convolveRows(map.omega, rows), columns);
  std::vector<Raster<double>> means;
  for (const Raster<double>& light : map.lights) {
    Raster<double>& mean = means.emplace_back(convolveColumns(convolveRows(light, rows), columns));
    for (std::size_t i = 0; i < mean.size(); ++i) mean[i] = map.omega[i] > 0.0 ? mean[i] / sky[i] : 0.0;
  }
  return means;
}

Reconstruction reconstructHits(const HitMap& map, const GaussianSettings& settings, const Watch& watch) {
  watch.at(0.0);
  const double sigma = settings.sigma.value_or(sizeByHits(map, kGaussianSigma));
  return {gaussianMeans(map, sigma), {sizeRemark("sigma", sigma)}};
}

}  // namespace parhelion
