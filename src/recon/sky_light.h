// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "picture/image.h"
#include "recon/hit_map.h"
#include "sky/tally.h"

namespace parhelion {

/// The light of a tally's sky in the units that filters work in, and the way back. Light in pixels without sky is left
/// out. The tally must outlive this.
class SkyLight {
 public:
  explicit SkyLight(const Tally& tally);

  const Tally& tally() const { return tally_; }

  /// sr, row-major, 0 for pixels without sky.
  const std::vector<double>& solidAngles() const { return solidAngles_; }

  /// Luminance of all of the sky, in the tally's unit.
  double light() const { return light_; }

  /// Effective hits per luminance: with it the luminance of independent hits has the variance of counts. 0 for a sky
  /// without light.
  double hitsPerLight() const { return hitsPerLight_; }
  double hits() const { return light_ * hitsPerLight_; }

  /// The kinds of light of a pixel with sky, in effective hits: luminance, the difference between its halves, X and Z.
  /// X and Z are 0 where the tally has luminance only.
  struct Pixel {
    double luminance, difference, x, z;
  };
  Pixel at(std::size_t pixel) const;

  /// All of it for the named methods: two kinds of light, or four with colour.
  HitMap hitMap() const;

  /// The image of filtered light of the same kinds, in effective hits per relative solid angle.
  Image develop(const std::vector<Raster<double>>& lights) const;

 private:
  const Tally& tally_;
  std::vector<double> solidAngles_;
  double light_ = 0.0, hitsPerLight_ = 0.0;
  double meanSolidAngle_ = 0.0;  // of the pixels that show sky, sr
};

/// Luminance, the difference between its halves (both in any one unit), and linear Rec.709 per that unit of a pixel.
struct FilteredLight {
  std::function<double(std::size_t)> luminance, difference;
  std::function<Vec3(std::size_t)> rgb;
  std::function<double(std::size_t)> hitsPerPixel;  // decides how wide the noise is averaged
  double hits = 0.0;                                // of all the sky, effective
};

/// The image of filtered light: `scale` turns its unit into 1/sr. The variance is the mean square of the halves'
/// difference over windows somewhat wider than kernels, relative to the luminance's; at least that of all the light.
Image developed(int width, int height, const FilteredLight& light, double scale);

/// R, G, B and the variance of the luminance, all 0.
Image emptyRadiance(int width, int height);

}  // namespace parhelion
