// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "picture/image.h"
#include "picture/raster.h"

namespace parhelion {

using GuideColour = std::array<float, 3>;

/// The guided filter of a colour picture (He, Sun & Tang 2013, "Guided image filtering", section 3.5): in each window
/// the result is linear in the guide's colour, so that it follows the guide's edges. The coefficients are smooth and
/// may be found on a small picture and used on a large one (He & Sun 2015, "Fast guided filter").
class GuidedFilter {
 public:
  /// Fits `input` to `guide`, of equal size, in windows of 2 radius + 1 pixels a side. `epsilon`: variance of the guide
  /// below which it is taken to be flat, in the guide's units squared.
  GuidedFilter(const Raster<GuideColour>& guide, const Raster<float>& input, int radius, float epsilon);

  /// The result at a place of the fitted pictures (pixels, centre of the first 0.5, 0.5) for the guide's colour there,
  /// with coefficients interpolated between pixels. Not limited to the input's range.
  float at(float x, float y, const GuideColour& colour) const;

 private:
  Raster<std::array<float, 4>> line_;  // three slopes and the offset, averaged over the windows that hold the pixel
};

}  // namespace parhelion
