// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "optics/sky_line.h"
#include "sky/camera.h"
#include "view/canvas.h"

namespace parhelion {

/// What a camera shows of a line on the sky inside `frame` (pixel coordinates): the great circles between its points,
/// to a tenth of a pixel, broken where the projection tears the sky apart, at the image circle and at the frame.
/// What lies on the seam of two discs is shown at the rims of both.
std::vector<PixelLine> linesInPicture(const Camera& camera, const SkyLine& line, const Box& frame);

}  // namespace parhelion
