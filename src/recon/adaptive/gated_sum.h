// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>

#include "recon/adaptive/left_out.h"
#include "recon/adaptive/scatter.h"

namespace parhelion {

/// A picture filtered with wide kernels, to which corrections by ever narrower ones are added where these stand above
/// the noise. Light 0 is the luminance in effective hits, light 1 the difference between two independent halves of it,
/// lights 2 and 3 are X and Z relative to white.
template <std::size_t N>
class GatedSum {
 public:
  /// The picture of kernels with `hits` hits; `placedBy` hits were under those of the density that placed them. Sky,
  /// field and light must outlive this.
  GatedSum(const SkyPyramid& sky, const KernelField& field, const Raster<Light<N>>& light, double hits,
           double placedBy);

  /// Adds what kernels of a quarter of the hits make better. A correction must exceed `caution` times its noise.
  /// `leftOut`, if any, is told what was not added.
  void refine(double caution, LeftOut* leftOut = nullptr);

  /// Tells `leftOut` what kernels of a quarter of the hits would make better. Nothing is added.
  void lookCloser(LeftOut& leftOut) const;

  /// Luminance and the difference between its halves, per relative solid angle (SkyLevel::omega).
  const Raster<Light<2>>& result() const { return sum_; }

  /// The same, and luminance, X and Z through gates of their own, of which only the ratios are of use (empty without
  /// colour), once: nothing is left to refine.
  Raster<Light<2>> takeResult() { return std::move(sum_); }
  Raster<Light<3>> takeColour() { return std::move(colour_); }

  /// Standard error of the luminance over the luminance, as it would be for independent hits of known density: what is
  /// measured must not be less than it. Once, too.
  Raster<float> takeLeastError() { return std::move(leastError_); }

 private:
  const SkyPyramid& sky_;
  const KernelField& field_;
  const Raster<Light<N>>& light_;
  double hits_, placedBy_;
  Raster<Light<N>> wide_;  // the last picture, of hits_
  Raster<Light<2>> sum_;
  Raster<Light<3>> colour_;
  Raster<float> gates_, colourGates_, leastError_;
};

extern template class GatedSum<2>;
extern template class GatedSum<4>;

}  // namespace parhelion
