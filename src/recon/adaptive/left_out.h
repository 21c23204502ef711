// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "recon/adaptive/scatter.h"
#include "recon/integral_image.h"

namespace parhelion {

/// Estimates how far a picture of gated corrections is from the sky on average over many runs: its bias.
///
/// What is left out of the picture is B = sum over the levels of (1 - gate) correction. Corrections are mostly noise
/// where gates are closed. But two independent halves of the hits give two independent estimates of each, so the mean
/// of the product of these is the square of what is really there. In the square of B, products of a correction with
/// itself and with the next finer one are counted: at an edge or on an arc, neighbouring levels lack the same light.
/// Means are taken over windows somewhat wider than the kernels. Where they come out negative they count as 0. So where
/// hits are few, noise remains in the estimate, and it is too large rather than too small.
class LeftOut {
 public:
  /// Sky and field must outlive this.
  LeftOut(const SkyPyramid& sky, const KernelField& field);

  /// The correction that kernels of `hits` hits make to those of four times as many, of which the share `gates` is kept
  /// (at half resolution; empty: nothing is kept). To be called for one level after the other, from coarse to fine.
  /// Light 0 is the luminance and light 1 the difference between its halves.
  template <std::size_t N>
  void add(const Raster<Light<N>>& wide, const Raster<Light<N>>& narrow, double hits, const Raster<float>& gates);

  /// The root of the mean square of B, per relative solid angle (SkyLevel::omega).
  Raster<float> rootMeanSquare() const;

 private:
  /// A correction and the difference between its halves, relative to the density that placed the
  /// kernels.
  using Correction = Light<2>;

  /// From sums over the sky pixels of blocks, the means over windows around them that suit kernels of `hits` hits.
  Raster<float> meanOver(const Raster<float>& blocks, double hits) const;

  /// The mean over windows of the product of two corrections, each taken from the other half of the hits.
  Raster<float> meanProduct(const Raster<Correction>& a, const Raster<Correction>& b, double hits) const;

  /// Adds `times` the product of the shares that are left out of two corrections.
  void addProduct(float times, const Raster<float>& product, const Raster<float>& gatesOfA,
                  const Raster<float>& gatesOfB);

  const SkyPyramid& sky_;
  const KernelField& field_;
  IntegralImage<double> skyPixels_;  // of blocks of 2 x 2
  Raster<float> squares_;            // of B, relative to the density, at half resolution
  Raster<Correction> coarser_;       // the correction before
  Raster<float> coarserGates_;
};

extern template void LeftOut::add(const Raster<Light<2>>&, const Raster<Light<2>>&, double, const Raster<float>&);
extern template void LeftOut::add(const Raster<Light<4>>&, const Raster<Light<4>>&, double, const Raster<float>&);

}  // namespace parhelion
