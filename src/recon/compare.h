// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "picture/image.h"
#include "sky/tally.h"

namespace parhelion {

/// How far a picture e of the sky is from a reference, of which A and B are independent estimates. All means are over
/// the sky by solid angle, of luminance unless said; e, A and B are divided by their mean luminance first. What A and B
/// scatter about the truth cancels in (e - A)(e - B): the truth has 0 in the mean, and may come out below it.
struct Comparison {
  /// Mean of (e - A)(e - B) / (R^2 + 0.01), R the mean of A and B under a Gaussian of 1 pixel. Wants references of tens
  /// of hits a pixel: at relative variances v of A and B the scatter of R adds 0.04 v^2 for the truth, and of the order
  /// of v times the error for what is wrong.
  double relMse = 0.0;
  double relMseError = 0.0;  // its standard error, from the spread over blocks of 16 x 16 pixels
  double mse = 0.0;          // mean of (e - A)(e - B): bright peaks decide
  /// Mean of log((e + 0.01) / (A + 0.01)) log((e + 0.01) / (B + 0.01)), e below 0 as 0. Of the scatter only what the
  /// logarithm bends stays: at relative variances v of A and B, v^2 / 4.
  double logMse = 0.0;
  /// Mean structural similarity (Wang et al. 2004: Gaussian window of 1.5 pixels, K1 = 0.01, K2 = 0.03) of e and
  /// (A + B)/2, both as log(1 + 10 e) / log(1 + 1000): 1 is a hundred times the mean. The scatter of A and B lowers it.
  double ssim = 0.0;
  double energyError = 0.0;     // all light of e over that of (A + B)/2, before any scaling, less 1
  double negativePixels = 0.0;  // share of the sky where the luminance of e is negative
  /// As relMse, for each of the channels R, G, B over the same (R^2 + G^2 + B^2)/3 + 0.01 of the smoothed reference:
  /// one channel alone passes through 0 where colours leave the gamut. Divided by the mean luminance, too: a cast over
  /// the whole sky counts. Of a pair with colour only.
  std::optional<std::array<double, 3>> relMseRgb;

  /// Mean of relMseRgb; 0 without.
  double meanRelMseRgb() const { return relMseRgb ? ((*relMseRgb)[0] + (*relMseRgb)[1] + (*relMseRgb)[2]) / 3.0 : 0.0; }
};

/// Throws std::invalid_argument unless camera, sun and white are the same. Crystals are not compared.
void requireSamePicture(const TallyInfo& a, const TallyInfo& b);

/// Whether a ray of the same seed is in both: then they are not independent.
bool shareRays(const TallyInfo& a, const TallyInfo& b);

/// Throws std::invalid_argument unless both are of the same picture and independent.
void requireReferencePair(const TallyInfo& a, const TallyInfo& b);

/// Compares a picture in 1/sr, channels R, G, B, without the sun drawn into it, with the plain radiances of tallies.
/// With one tally A and B are its two halves, with two they are these. Independence of e is the caller's matter. A
/// black picture is not scaled; numbers that are not finite make results that are not.
/// Throws std::invalid_argument for another size, for a pair that is none, and for halves without light.
Comparison compare(const Image& sky, const Tally& a, const Tally* b = nullptr);

}  // namespace parhelion
