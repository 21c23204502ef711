// SPDX-License-Identifier: Apache-2.0
#include "recon/adaptive_filter.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "math/portable.h"
#include "recon/gates.h"
#include "recon/structure_tensor.h"

namespace parhelion {
namespace {

/// Hits under a kernel of the last pilot over those under a middling kernel.
constexpr double kPilotShare = 0.5;

/// How many times a correction must exceed its noise. With few hits a blurred arc costs more than a little noise, with
/// many it is the other way round. Measured; a tenth more or less changes little.
double cautionFor(double hits) {
  return std::clamp(2.0 + 0.5 * portable::log(hits / 3.5e5) / portable::log(10.0), 1.5, 3.0);
}

/// Kernels for `density` hits per relative solid angle; an empty grid of shapes is all round.
KernelField fieldOf(const SkyPyramid& sky, const Grid<Light<1>>& density, const Grid<KernelShape>& shapes,
                    double totalHits) {
  // Where nothing came near, kernels are as wide as the picture allows.
  const float least = static_cast<float>(1e-6 * totalHits / static_cast<double>(sky.skyPixels()));
  Grid<KernelSite> sites(sky.width(), sky.height());
  for (std::size_t i = 0; i < sites.size(); ++i) {
    sites[i].density = std::max(density[i][0], least) * sky.wholeOmega()[i];
    if (shapes.size() > 0) sites[i].shape = shapes[i];
  }
  return {sky, std::move(sites)};
}

/// Density by density, finer each time, until sizes and shapes of the kernels are settled.
KernelField settleKernels(const SkyPyramid& sky, const Grid<Light<1>>& hits, Grid<Light<1>> density, double totalHits) {
  const double n = hitsPerKernel(totalHits);
  constexpr double kFirstHits = 32.0;
  density = scatter<1>(sky, fieldOf(sky, density, {}, totalHits), hits, kFirstHits);
  density = scatter<1>(sky, fieldOf(sky, density, {}, totalHits), hits, n);
  const Grid<KernelShape> shapes = kernelShapes(sky, density, n);
  // Kernels along the arcs can do with half the hits: the density follows bright arcs more closely.
  density = scatter<1>(sky, fieldOf(sky, density, shapes, totalHits), hits, kPilotShare * n);
  return fieldOf(sky, density, shapes, totalHits);
}

/// Deviation of a picture over that which fixed kernels would give. The hits place the kernels that spread them, by a
/// density of pilotHits under a kernel: where they happen to be many, kernels are also narrower and higher. To first
/// order, for Gaussians of Fourier transform exp(-v/2) and a pilot of exp(-r v/2), the transform of the whole response
/// is exp(-v/2) (1 + v/2 exp(-r v/2)), whose square integral over v this is.
float placementNoise(double hits, double pilotHits) {
  const double r = pilotHits / hits;
  const double a = 1.0 + 0.5 * r, b = 1.0 + r;
  return static_cast<float>(std::sqrt(1.0 + 1.0 / (a * a) + 0.5 / (b * b * b)));
}

template <std::size_t N>
Filtered widest(const Grid<Light<N>>& picture, float noise) {
  Filtered result{{picture.width(), picture.height()}, {}};
  if constexpr (N == 4) result.colour = {picture.width(), picture.height()};
  for (std::size_t i = 0; i < picture.size(); ++i) {
    const Light<N>& light = picture[i];
    result.luminance[i] = {light[0], noise * light[1]};
    if constexpr (N == 4) result.colour[i] = {light[0], light[2], light[3]};
  }
  return result;
}

template <std::size_t N>
void addLuminance(Filtered& sum, const Grid<float>& gates, const Grid<Light<N>>& wide, float wideNoise,
                  const Grid<Light<N>>& narrow, float narrowNoise) {
  forRows(wide.height(), [&](int y) {
    for (int x = 0; x < wide.width(); ++x) {
      const float gate = gateAt(gates, x, y);
      const Light<N>&from = wide.at(x, y), &to = narrow.at(x, y);
      Light<2>& light = sum.luminance.at(x, y);
      light[0] += gate * (to[0] - from[0]);
      light[1] += gate * (narrowNoise * to[1] - wideNoise * from[1]);
    }
  });
}

void addColour(Filtered& sum, const Grid<float>& gates, const Grid<Light<4>>& wide, const Grid<Light<4>>& narrow) {
  forRows(wide.height(), [&](int y) {
    for (int x = 0; x < wide.width(); ++x) {
      const float gate = gateAt(gates, x, y);
      const Light<4>&from = wide.at(x, y), &to = narrow.at(x, y);
      Light<3>& light = sum.colour.at(x, y);
      light[0] += gate * (to[0] - from[0]);
      light[1] += gate * (to[2] - from[2]);
      light[2] += gate * (to[3] - from[3]);
    }
  });
}

}  // namespace

double hitsPerKernel(double hits) {
  // Measured on a display with plates and columns from 4e3 to 4e6 hits; half or double costs a tenth to a third.
  return std::clamp(0.9 * portable::exp(0.4 * portable::log(std::max(hits, 1.0))), 16.0, 1024.0);
}

template <std::size_t N>
Filtered adaptiveFilter(const SkyPyramid& sky, const Grid<Light<N>>& light, const Grid<float>& firstDensity) {
  Grid<Light<1>> hits(sky.width(), sky.height()), density(sky.width(), sky.height());
  double totalHits = 0.0;
  for (std::size_t i = 0; i < hits.size(); ++i) {
    hits[i] = {light[i][0]};
    density[i] = {firstDensity[i]};
    totalHits += static_cast<double>(light[i][0]);
  }
  const KernelField field = settleKernels(sky, hits, std::move(density), totalHits);
  hits = {};

  const double n = hitsPerKernel(totalHits), caution = cautionFor(totalHits);
  Grid<Light<N>> wider, wide = scatter<N>(sky, field, light, 16.0 * n);
  float wideNoise = placementNoise(16.0 * n, kPilotShare * n);
  Filtered sum = widest(wide, wideNoise);
  Grid<float> gates;
  for (const double share : {4.0, 1.0, 1.0 / 4.0, 1.0 / 16.0}) {
    Grid<Light<N>> narrow = scatter<N>(sky, field, light, share * n);
    const Corrections corrections = compareSizes<N>(sky, field, wide, narrow, share * n);
    gates = correctionGates(corrections, field, share * n, caution * corrections.noiseRatio, gates);
    const float narrowNoise = placementNoise(share * n, kPilotShare * n);
    addLuminance<N>(sum, gates, wide, wideNoise, narrow, narrowNoise);
    wideNoise = narrowNoise;
    // Colour follows one size behind, through the same gates.
    if constexpr (N == 4) {
      if (wider.size() > 0) addColour(sum, gates, wider, wide);
      wider = std::move(wide);
    }
    wide = std::move(narrow);
  }
  return sum;
}

template Filtered adaptiveFilter(const SkyPyramid&, const Grid<Light<2>>&, const Grid<float>&);
template Filtered adaptiveFilter(const SkyPyramid&, const Grid<Light<4>>&, const Grid<float>&);

}  // namespace parhelion
