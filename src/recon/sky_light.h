// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "picture/image.h"
#include "recon/hit_map.h"
#include "sky/tally.h"

namespace parhelion {

/// The light of a tally in the units that filters work in, and the conversion of filtered light to an image. Light in
/// pixels without sky is left out. The tally must outlive this object.
class SkyLight {
 public:
  explicit SkyLight(const Tally& tally);

  const Tally& tally() const { return tally_; }

  /// Solid angles of the pixels in sr, row-major; 0 for pixels without sky.
  const std::vector<double>& solidAngles() const { return solidAngles_; }

  /// The luminance of all pixels with sky together, in the tally's unit.
  double light() const { return light_; }

  /// Effective hits per unit of luminance: the sum of the light over the sum of its squares. In this unit the luminance
  /// of independent hits has the variance of counts. 0 for a sky without light.
  double hitsPerLight() const { return hitsPerLight_; }
  double hits() const { return light_ * hitsPerLight_; }

  /// The light of a pixel with sky, in effective hits: its luminance, the difference between the luminance's halves, X
  /// and Z. X and Z are 0 where the tally has luminance only.
  struct Pixel {
    double luminance, difference, x, z;
  };
  Pixel at(std::size_t pixel) const;

  /// All pixels, for the published methods. The map has two kinds of light, or four with colour, in the order of Pixel.
  HitMap hitMap() const;

  /// The image of filtered light. `lights` has the same kinds, in effective hits per relative solid angle.
  Image develop(const std::vector<Raster<double>>& lights) const;

 private:
  const Tally& tally_;
  std::vector<double> solidAngles_;
  double light_ = 0.0, hitsPerLight_ = 0.0;
  double meanSolidAngle_ = 0.0;  // of the pixels that show sky, sr
};

/// What a filter made of each pixel. Luminance, the difference between its halves and `rgb` (linear Rec.709) are in one
/// and the same unit, which may be any.
struct FilteredLight {
  std::function<double(std::size_t)> luminance, difference;
  std::function<Vec3(std::size_t)> rgb;
  std::function<double(std::size_t)> hitsPerPixel;  // decides over which width the noise is averaged
  double hits = 0.0;                                // effective hits in all the sky
  // What some methods know besides, or empty: the least standard error of the luminance over the luminance, and the
  // bias of the luminance.
  std::function<double(std::size_t)> leastError, bias;
};

/// The image of filtered light, with the variance of its luminance. `scale` converts the light's unit to 1/sr.
///
/// The relative variance of a pixel is a quotient of two sums over a window somewhat wider than the kernels: the
/// squares of the difference between the halves, over the squares of the luminance. It is at least that of all the
/// light together, which is 1 / hits, and at least the square of `leastError`. With a bias, the image has a channel for
/// it.
Image developed(int width, int height, const FilteredLight& light, double scale);

/// An image with the channels R, G, B and the variance of the luminance, all 0.
Image emptyRadiance(int width, int height);

}  // namespace parhelion
