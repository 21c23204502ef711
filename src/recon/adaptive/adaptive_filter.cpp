// SPDX-License-Identifier: Apache-2.0
#include "recon/adaptive/adaptive_filter.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "math/portable.h"
#include "parallel/loops.h"
#include "recon/adaptive/gated_sum.h"
#include "recon/adaptive/growing_squares.h"
#include "recon/adaptive/halving.h"
#include "recon/adaptive/structure_tensor.h"
#include "sky/fixed_point.h"

namespace parhelion {
namespace {

/// Hits under a kernel of the last pilot over those under a middling kernel.
constexpr double kPilotShare = 0.5;

/// How many times a correction must exceed its noise. With few hits a blurred arc costs more than a little noise, with
/// many it is the other way round. Measured; a tenth more or less changes little.
double cautionFor(double hits) {
  return std::clamp(2.0 + 0.8 * portable::log(hits / 3.5e5) / portable::log(10.0), 1.5, 3.0);
}

/// Hits under a middling kernel, for a picture of so many hits.
double hitsPerKernel(double hits) {
  // Measured on a display with plates and columns from 4e3 to 4e6 hits; half or double costs a tenth to a third.
  return std::clamp(0.5 * portable::exp(0.45 * portable::log(std::max(hits, 1.0))), 16.0, 2048.0);
}

/// Kernels for `density` hits per relative solid angle; an empty raster of shapes is all round in the sky.
KernelField fieldOf(const SkyPyramid& sky, const Raster<Light<1>>& density, const Raster<KernelShape>& shapes,
                    double totalHits) {
  constexpr double kLeastDensity = 1e-6;  // of the mean, where nothing came near: kernels as wide as a picture allows
  const float least = static_cast<float>(kLeastDensity * totalHits / static_cast<double>(sky.skyPixels()));
  Raster<KernelSite> sites(sky.width(), sky.height());
  forRows(sky.height(), [&](int y) {
    const KernelShape round = KernelShape{}.stretched(sky.stretch(y));
    for (int x = 0; x < sky.width(); ++x) {
      sites.at(x, y).density = std::max(density.at(x, y)[0], least) * sky.wholeOmega().at(x, y);
      sites.at(x, y).shape = shapes.size() > 0 ? shapes.at(x, y) : round;
    }
  });
  return {sky, std::move(sites)};
}

/// Hits per relative solid angle in squares that hold `enough` of them, in fixed point so that sums are exact.
Raster<Light<1>> firstDensity(const SkyPyramid& sky, const Raster<Light<1>>& hits, double enough) {
  constexpr double kScale = 1 << 20;  // 1e12 hits fit
  Raster<std::int64_t> fixed(sky.width(), sky.height());
  for (std::size_t i = 0; i < fixed.size(); ++i) fixed[i] = toFixed(static_cast<double>(hits[i][0]), kScale);
  const Raster<float> density = growingSquares(sky, fixed, toFixed(enough, kScale));
  Raster<Light<1>> result(sky.width(), sky.height());
  for (std::size_t i = 0; i < fixed.size(); ++i) result[i] = {density[i] * static_cast<float>(1.0 / kScale)};
  return result;
}

/// The kernels of the density once more, which those of a rougher one and its shapes have spread. Kernels along the
/// arcs can do with half the hits: the density follows bright arcs more closely.
KernelField sharpened(const SkyPyramid& sky, const Raster<Light<1>>& hits, const Raster<Light<1>>& density,
                      const Raster<KernelShape>& shapes, double totalHits) {
  const double enough = kPilotShare * hitsPerKernel(totalHits);
  return fieldOf(sky, scatter<1>(sky, fieldOf(sky, density, shapes, totalHits), hits, enough), shapes, totalHits);
}

/// Density by density, finer each time, until sizes and shapes of the kernels are settled.
KernelField settleKernels(const SkyPyramid& sky, const Raster<Light<1>>& hits, double totalHits) {
  const double n = hitsPerKernel(totalHits);
  constexpr double kFirstHits = 32.0;
  Raster<Light<1>> density = firstDensity(sky, hits, std::min(0.5 * n, totalHits));
  density = scatter<1>(sky, fieldOf(sky, density, {}, totalHits), hits, kFirstHits);
  density = scatter<1>(sky, fieldOf(sky, density, {}, totalHits), hits, n);
  const Raster<KernelShape> shapes = kernelShapes(sky, density, n);
  return sharpened(sky, hits, density, shapes, totalHits);
}

/// The kernels of a picture from a look at it at half the resolution: there the whole method is run once, but for its
/// finest corrections, and what comes out places and shapes the kernels.
KernelField lookedAtFrom(const SkyPyramid& half, const Raster<Light<2>>& halfLight, const SkyPyramid& sky,
                         const Raster<Light<1>>& hits, double totalHits) {
  const double n = hitsPerKernel(totalHits), caution = cautionFor(totalHits);
  const KernelField field = settleKernels(half, firstOf<1>(halfLight), totalHits);
  GatedSum<2> look(half, field, halfLight, 16.0 * n, kPilotShare * n);
  for (int finer = 0; finer < 3; ++finer) look.refine(caution);

  Raster<Light<1>> density = firstOf<1>(look.result());
  const Raster<KernelShape> shapes = kernelShapes(half, density, n);
  Raster<Light<3>> sites(half.width(), half.height()), fine(sky.width(), sky.height());
  for (std::size_t i = 0; i < sites.size(); ++i) sites[i] = {density[i][0], shapes[i].p, shapes[i].q};
  addInterpolated(fine, sky.pixels(), sites, half.pixels());
  const float perCell = sky.levels() > 1 ? 0.25F : 1.0F;
  density = {sky.width(), sky.height()};
  Raster<KernelShape> fineShapes(sky.width(), sky.height());
  for (std::size_t i = 0; i < fine.size(); ++i) {
    density[i][0] = perCell * fine[i][0];
    fineShapes[i] = {fine[i][1], fine[i][2]};
  }
  return sharpened(sky, hits, density, fineShapes, totalHits);
}

}  // namespace

template <std::size_t N>
Filtered adaptiveFilter(const SkyPyramid& sky, const Raster<Light<N>>& light, double totalHits, const Watch& watch) {
  const SkyPyramid half = sky.halved();
  const Raster<Light<N>> halfLight = sky.levels() > 1 ? halved(light) : light;
  const double n = hitsPerKernel(totalHits), caution = cautionFor(totalHits);

  watch.at(0.0);
  const KernelField field = lookedAtFrom(half, firstOf<2>(halfLight), sky, firstOf<1>(light), totalHits);
  watch.at(0.4);
  GatedSum<N> sum(sky, field, light, 16.0 * n, kPilotShare * n);
  LeftOut leftOut(sky, field);
  for (const double done : {0.5, 0.6, 0.7, 0.8}) {
    watch.at(done);
    sum.refine(caution, &leftOut);
  }
  watch.at(0.9);
  sum.lookCloser(leftOut);
  return {sum.takeResult(), sum.takeColour(), sum.takeLeastError(), leftOut.rootMeanSquare()};
}

template Filtered adaptiveFilter(const SkyPyramid&, const Raster<Light<2>>&, double, const Watch&);
template Filtered adaptiveFilter(const SkyPyramid&, const Raster<Light<4>>&, double, const Watch&);

}  // namespace parhelion
