// SPDX-License-Identifier: Apache-2.0
#include "recon/adaptive/gated_sum.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "parallel/loops.h"
#include "recon/adaptive/gates.h"

namespace parhelion {
namespace {

/// Deviation of a picture over that which fixed kernels would give. The hits place the kernels that spread them, by a
/// density of pilotHits under a kernel: where they happen to be many, kernels are also narrower and higher. To first
/// order, for Gaussians of Fourier transform exp(-v/2) and a pilot of exp(-r v/2), the transform of the whole response
/// is exp(-v/2) (1 + v/2 exp(-r v/2)), whose square integral over v this is.
float placementNoise(double hits, double pilotHits) {
  const double r = pilotHits / hits;
  const double a = 1.0 + 0.5 * r, b = 1.0 + r;
  return static_cast<float>(std::sqrt(1.0 + 1.0 / (a * a) + 0.5 / (b * b * b)));
}

/// Deviation over the luminance where fixed kernels have `hits` hits under them and a pixel gets `density`: kernels are
/// no narrower than a pixel.
float fixedKernelNoise(double hits, float density) {
  return 1.0F / std::sqrt(std::max(static_cast<float>(hits), density));
}

/// How many times a correction of colour must exceed its noise. Measured, as the error of R, G and B; at many hits less
/// than for the luminance, for what is lost of colour shows at the arcs.
constexpr double kColourCaution = 1.0;

}  // namespace

template <std::size_t N>
GatedSum<N>::GatedSum(const SkyPyramid& sky, const KernelField& field, const Raster<Light<N>>& light, double hits,
                      double placedBy)
    : sky_(sky),
      field_(field),
      light_(light),
      hits_(hits),
      placedBy_(placedBy),
      wide_(scatter<N>(sky, field, light, hits)),
      sum_(sky.width(), sky.height()),
      leastError_(sky.width(), sky.height()) {
  if (N == 4) colour_ = {sky.width(), sky.height()};
  const float noise = placementNoise(hits, placedBy);
  for (std::size_t i = 0; i < sum_.size(); ++i) {
    sum_[i] = {wide_[i][0], noise * wide_[i][1]};
    leastError_[i] = noise * fixedKernelNoise(hits, field.pixels()[i].density);
    if constexpr (N == 4) colour_[i] = {wide_[i][0], wide_[i][2], wide_[i][3]};
  }
}

template <std::size_t N>
void GatedSum<N>::refine(double caution, LeftOut* leftOut) {
  const double narrowHits = 0.25 * hits_;
  Raster<Light<N>> narrow = scatter<N>(sky_, field_, light_, narrowHits);
  const Corrections corrections = compareSizes<N>(sky_, field_, wide_, narrow, narrowHits);
  gates_ = correctionGates(corrections, field_, narrowHits, caution, gates_);
  if (N == 4) colourGates_ = colourGates(corrections, field_, narrowHits, kColourCaution, colourGates_);
  if (leftOut != nullptr) leftOut->add(wide_, narrow, narrowHits, gates_);
  const float wideNoise = placementNoise(hits_, placedBy_), narrowNoise = placementNoise(narrowHits, placedBy_);
  forRows(sky_.height(), [&](int y) {
    for (int x = 0; x < sky_.width(); ++x) {
      const Light<N>&from = wide_.at(x, y), &to = narrow.at(x, y);
      const float gate = gateAt(gates_, x, y);
      sum_.at(x, y)[0] += gate * (to[0] - from[0]);
      sum_.at(x, y)[1] += gate * (narrowNoise * to[1] - wideNoise * from[1]);
      const float density = field_.pixels().at(x, y).density;
      leastError_.at(x, y) +=
          gate * (narrowNoise * fixedKernelNoise(narrowHits, density) - wideNoise * fixedKernelNoise(hits_, density));
      if constexpr (N == 4) {
        // In saturated arcs the noise of colour is larger than elsewhere: no more of it than of the luminance.
        const float colourGate = std::min(gate, gateAt(colourGates_, x, y));
        Light<3>& colour = colour_.at(x, y);
        colour[0] += colourGate * (to[0] - from[0]);
        colour[1] += colourGate * (to[2] - from[2]);
        colour[2] += colourGate * (to[3] - from[3]);
      }
    }
  });
  wide_ = std::move(narrow);
  hits_ = narrowHits;
}

template <std::size_t N>
void GatedSum<N>::lookCloser(LeftOut& leftOut) const {
  const double narrowHits = 0.25 * hits_;
  leftOut.add(firstOf<2>(wide_), scatter<2>(sky_, field_, firstOf<2>(light_), narrowHits), narrowHits, {});
}

template class GatedSum<2>;
template class GatedSum<4>;

}  // namespace parhelion
