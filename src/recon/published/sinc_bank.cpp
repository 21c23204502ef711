// SPDX-License-Identifier: Apache-2.0
#include "recon/published/sinc_bank.h"

#include <cmath>

#include "parallel/loops.h"
#include "recon/published/sinc_kernel.h"

namespace parhelion {
namespace {

constexpr int kStepsPerOctave = 16;
constexpr int kOwnSteps = 32;  // radii below have a kernel each

/// The radius of a step: 0 ... 31, then 32, 34, ... 62, 64, 68, ...
int radiusOf(std::size_t step) {
  const int s = static_cast<int>(step);
  if (s < kOwnSteps) return s;
  const int octave = (s - kOwnSteps) / kStepsPerOctave + 1;
  return (kStepsPerOctave + (s - kOwnSteps) % kStepsPerOctave) << octave;
}

}  // namespace

SincKernel::SincKernel(double radius, double lobes, KernelGain gain, bool oneColumn, bool oneRow) {
  const int reach = std::max(static_cast<int>(std::ceil(radius)) - 1, 0);  // it is 0 at its radius
  const double period = radius / lobes;
  double sum = 0.0;
  std::vector<double> weights, half;
  for (int y = 0; y <= (oneRow ? 0 : reach); ++y) {
    half.clear();
    for (int x = 0; x <= (oneColumn ? 0 : reach); ++x) {
      const double t = std::sqrt(static_cast<double>(x) * x + static_cast<double>(y) * y);
      if (t > 0.0 && t >= radius) break;
      half.push_back(windowedSinc(t, period, lobes));
      sum += half.back() * (x > 0 ? 2.0 : 1.0) * (y > 0 ? 2.0 : 1.0);
    }
    const auto count = half.size();
    rows_.push_back({static_cast<int>(count) - 1, weights.size() + count - 1});
    weights.insert(weights.end(), half.rbegin(), half.rend());
    weights.insert(weights.end(), half.begin() + 1, half.end());
  }
  const double scale = gain == KernelGain::unit ? 1.0 / sum : 1.0;
  for (const double weight : weights) weights_.push_back(static_cast<float>(weight * scale));
}

std::size_t SincBank::step(int radius) {
  if (radius < kOwnSteps) return static_cast<std::size_t>(radius);
  int octave = 1;
  while ((radius >> octave) >= 2 * kStepsPerOctave) ++octave;
  return static_cast<std::size_t>(kOwnSteps + (octave - 1) * kStepsPerOctave + (radius >> octave) - kStepsPerOctave);
}

int SincBank::rounded(int radius) { return radiusOf(step(radius)); }

SincBank::SincBank(const Raster<int>& radii, const PictureShape& shape, double lobes, KernelGain gain) {
  index_.assign(step(std::max(shape.width, shape.height)) + 1, -1);
  for (std::size_t i = 0; i < radii.size(); ++i) index_[step(radii[i])] = 0;
  int count = 0;
  for (int& index : index_) {
    if (index == 0) index = count++;
  }
  kernels_.resize(static_cast<std::size_t>(count), SincKernel(0.0, lobes, gain, false, false));
  forEach(index_.size(), [&](std::size_t s) {
    if (index_[s] < 0) return;
    kernels_[static_cast<std::size_t>(index_[s])] =
        SincKernel(radiusOf(s), lobes, gain, shape.width == 1, shape.height == 1);
  });
}

std::size_t SincBank::bytes() const {
  std::size_t sum = 0;
  for (const SincKernel& kernel : kernels_) sum += kernel.bytes();
  return sum;
}

double sumUnder(const SincKernel& kernel, const Raster<float>& grid, int x, int y, const PictureShape& shape) {
  double sum = 0.0;
  forColumns(y, kernel.reachY(), shape.height, shape.wrapY, [&](int top, int rows, int dy) {
    for (int j = 0; j < rows; ++j) {
      const SincKernel::Row row = kernel.row(dy + j);
      const float* values = grid.row(top + j);
      forColumns(x, row.reach, shape.width, shape.wrapX, [&](int from, int count, int dx) {
        sum += static_cast<double>(dot(row.weights + dx, values + from, count));
      });
    }
  });
  return sum;
}

}  // namespace parhelion
