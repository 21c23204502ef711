// SPDX-License-Identifier: Apache-2.0
#include "recon/adaptive/gates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "math/portable.h"
#include "parallel/loops.h"
#include "recon/adaptive/halving.h"
#include "recon/integral_image.h"
#include "recon/kernel_variance.h"

namespace parhelion {
namespace {

/// Noise of a correction: s times the square integral of the difference between kernels of variance s and 4 s. It is
/// constant until kernels shrink to a pixel.
class CorrectionNoise {
 public:
  CorrectionNoise() {
    for (int i = 0; i < kSteps; ++i) {
      const double sigma = portable::exp(std::numbers::ln2 * (kFirstOctave + static_cast<double>(i) / kPerOctave));
      values_[static_cast<std::size_t>(i)] = static_cast<float>(sigma * sigma * squareOfDifference(sigma));
    }
  }

  float at(float variance) const {
    const float t = (0.5F * roughLog2(variance) - kFirstOctave) * kPerOctave;
    const float clamped = std::clamp(t, 0.0F, kLastStep);
    const auto i = static_cast<std::size_t>(clamped);
    return values_[i] + (clamped - static_cast<float>(i)) * (values_[i + 1] - values_[i]);
  }

 private:
  static constexpr int kFirstOctave = -3, kPerOctave = 4, kSteps = 21;  // sigma = 1/8 ... 4 pixels
  static constexpr float kLastStep = kSteps - 1.001F;                   // a little less, so that there is a next one

  static double squareOfDifference(double sigma) {
    const Kernel narrow(sigma, sigma, 0.0), wide(2.0 * sigma, 2.0 * sigma, 0.0);
    double sum = 0.0;
    for (int dy = -wide.rowReach(); dy <= wide.rowReach(); ++dy) {
      const Kernel::Row row = wide.row(dy);
      for (int i = 0; i < row.count; ++i) {
        double difference = static_cast<double>(row.weights[i]);
        if (std::abs(dy) <= narrow.rowReach()) {
          const Kernel::Row inner = narrow.row(dy);
          const int j = row.from + i - inner.from;
          if (j >= 0 && j < inner.count) difference -= static_cast<double>(inner.weights[j]);
        }
        sum += difference * difference;
      }
    }
    return sum;
  }

  std::array<float, kSteps> values_{};
};

const CorrectionNoise& correctionNoise() {
  static const CorrectionNoise noise;
  return noise;
}

// A difference of 10 standard deviations is no noise but a pixel whose density was misjudged: a few of these must not
// decide for all.
constexpr float kMostOverNoise = 100.0F;

/// The median over the blocks of what changes in colour over the noise.
double medianColour(const Raster<CorrectionSquares>& blocks) {
  std::vector<float> ratios;
  ratios.reserve(blocks.size());
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    if (blocks[i].noise > 0.0F) ratios.push_back(blocks[i].colour / blocks[i].noise);
  }
  if (ratios.empty()) return 1.0;
  // The square of a normal deviate has this median: a block's pixels, and X and Z, vary nearly as one.
  constexpr double kMedianOfSquare = 0.455;
  const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
  std::nth_element(ratios.begin(), middle, ratios.end());
  return static_cast<double>(*middle) / kMedianOfSquare;
}

/// Gates for one kind of squares.
Raster<float> gatesFor(float CorrectionSquares::*squares, const Corrections& corrections, const KernelField& field,
                       double hits, double caution, const Raster<float>& coarser) {
  const Raster<CorrectionSquares>& blocks = corrections.blocks;
  const auto sums = [&](float CorrectionSquares::*part) {
    return IntegralImage<double>(blocks.width(), blocks.height(),
                                 [&, part](int x, int y) { return blocks.at(x, y).*part; });
  };
  const auto correction = sums(squares), noise = sums(&CorrectionSquares::noise);

  constexpr double kRounding = 1e-9;  // of the sums: at most 1e4 a block, 1e8 blocks, 1e-16 of that
  Raster<float> gates(blocks.width(), blocks.height());
  forRows(blocks.height(), [&](int y) {
    for (int x = 0; x < blocks.width(); ++x) {
      if (blocks.at(x, y).pixels <= 0.0F) continue;
      const int r = windowRadius(field, x, y, hits);
      const double kept = correction.square(x, y, r), lost = caution * noise.square(x, y, r);
      const float coarserGate = coarser.size() > 0 ? coarser.at(x, y) : 1.0F;
      if (kept > lost + kRounding) gates.at(x, y) = coarserGate * static_cast<float>(1.0 - lost / kept);
    }
  });
  return gates;
}

}  // namespace

int windowRadius(const KernelField& field, int x, int y, double hits) {
  constexpr double kWindow = 2.0;                     // half side, standard deviations of the kernels
  constexpr double kLeastWindow = 1.5;                // blocks
  const int level = std::min(1, field.levels() - 1);  // a single pixel has but one
  const double sigma = std::sqrt(static_cast<double>(kernelVariance(hits, field.level(level).at(x, y).density)));
  return static_cast<int>(std::clamp(0.5 * kWindow * sigma, kLeastWindow, kBeyondAnyPicture) + 0.5);
}

template <std::size_t N>
Corrections compareSizes(const SkyPyramid& sky, const KernelField& field, const Raster<Light<N>>& wide,
                         const Raster<Light<N>>& narrow, double hits) {
  Corrections result;
  result.blocks = {halfOf(sky.width()), halfOf(sky.height())};
  const Vec2 sums = sumOverRows(result.blocks.height(), [&](int by) {
    Vec2 row(0.0);  // measured, expected
    for (int y = 2 * by; y < std::min(2 * by + 2, sky.height()); ++y) {
      for (int x = 0; x < sky.width(); ++x) {
        if (sky.pixels().omega.at(x, y) <= 0.0F) continue;
        const float density = field.pixels().at(x, y).density;
        const float perDensity = sky.wholeOmega().at(x, y) / density;
        const float correction = (narrow.at(x, y)[0] - wide.at(x, y)[0]) * perDensity;
        const float difference = (narrow.at(x, y)[1] - wide.at(x, y)[1]) * perDensity;
        const float variance = kernelVariance(hits, density);
        const float noise = correctionNoise().at(variance) / (variance * density);
        CorrectionSquares& block = result.blocks.at(x / 2, by);
        block.correction += std::min(correction * correction, kMostSquare);
        block.noise += noise;
        if constexpr (N == 4) {
          // Light that wide kernels spread from a bright place has that place's relative noise of colour.
          const float perLight = 1.0F / std::max(wide.at(x, y)[0], 1.0F / perDensity);
          const float luminance = narrow.at(x, y)[0] - wide.at(x, y)[0];
          for (const std::size_t c : {2, 3}) {
            const float colour = (narrow.at(x, y)[c] - wide.at(x, y)[c] - luminance) * perLight;
            block.colour += colour * colour;
          }
        }
        block.pixels += 1.0F;
        if (!sky.counts(x, y)) continue;
        row += Vec2(density * std::min(difference * difference, kMostOverNoise * noise), density * noise);
      }
    }
    return row;
  });
  if (sums.y > 0.0) result.noiseRatio = sums.x / sums.y;
  if (N == 4) result.colourRatio = medianColour(result.blocks);
  return result;
}

template Corrections compareSizes(const SkyPyramid&, const KernelField&, const Raster<Light<2>>&,
                                  const Raster<Light<2>>&, double);
template Corrections compareSizes(const SkyPyramid&, const KernelField&, const Raster<Light<4>>&,
                                  const Raster<Light<4>>&, double);

Raster<float> correctionGates(const Corrections& corrections, const KernelField& field, double hits, double caution,
                              const Raster<float>& coarser) {
  return gatesFor(&CorrectionSquares::correction, corrections, field, hits, caution * corrections.noiseRatio, coarser);
}

Raster<float> colourGates(const Corrections& corrections, const KernelField& field, double hits, double caution,
                          const Raster<float>& coarser) {
  return gatesFor(&CorrectionSquares::colour, corrections, field, hits, caution * corrections.colourRatio, coarser);
}

float gateAt(const Raster<float>& gates, int x, int y) {
  const int x0 = x / 2, x1 = nextNearest(x, gates.width());
  const int y0 = y / 2, y1 = nextNearest(y, gates.height());
  return (9.0F * gates.at(x0, y0) + 3.0F * (gates.at(x1, y0) + gates.at(x0, y1)) + gates.at(x1, y1)) / 16.0F;
}

}  // namespace parhelion
