// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "picture/image.h"
#include "sky/camera.h"

namespace parhelion {

/// A picture of the halo's light, looked up from the pixels of a photograph. Between the centres of the picture's
/// pixels, whose values are means over them, light changes bilinearly: never below 0, and as much altogether. Pixels
/// without sky have no part in it. A picture that is finer than the photograph is averaged over squares first, and
/// looked up in four places a pixel.
class HaloLookup {
 public:
  /// `halo` has channels R, G, B and the size of `haloCamera`; samples that are not finite count as 0. Throws
  /// std::invalid_argument otherwise.
  HaloLookup(const Image& halo, const CameraSettings& haloCamera, const CameraSettings& photoCamera);

  /// The light seen in the pixel about a place of the photograph (pixel coordinates), in the halo's unit, not below 0;
  /// none where the photograph shows no sky or the halo's picture does not reach.
  std::optional<Vec3> at(Vec2 place) const;

 private:
  std::optional<Vec3> lightAt(Vec2 place) const;
  std::optional<Vec2> haloPlace(Vec2 place) const;
  int column(int x, double place) const;

  Camera haloCamera_, photoCamera_;
  int width_, height_;       // of the averaged picture
  int squares_;              // side of the squares averaged over, pixels
  bool finer_;               // the averaged picture's pixels are still smaller than the photograph's
  bool sameLens_;            // pixels of the one are pixels of the other but for their size
  bool wraps_;               // a whole turn: the left border is the right one's neighbour
  std::vector<Vec3> light_;  // row-major
  std::vector<double> sky_;  // share of each that shows sky, row-major
};

}  // namespace parhelion
