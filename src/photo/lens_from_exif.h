// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "picture/exif.h"
#include "sky/camera_settings.h"

namespace parhelion {

/// A lens as Exif tells of it.
struct LensFacts {
  double focalPixels;  // pixels per radian along the optical axis, in the picture as it is now
  std::string source;  // which fields it is from, in words
};

/// The focal length of a picture of `width` x `height` pixels, from focal length and focal-plane resolution or from the
/// 35 mm equivalent (CIPA DC-008: the same diagonal field of view on 36 mm x 24 mm film). The first is finer; where the
/// two are more than a fifth apart, the second is taken, for makers state resolutions of other sizes than the
/// picture's. A picture that was made smaller or larger since, or turned, has its focal length scaled with it; without
/// pixel numbers in Exif it is taken for unscaled. None where Exif has neither. Throws std::invalid_argument naming the
/// value where it cannot be (zero, negative, infinite, beyond all lenses), and where the picture has been cropped.
std::optional<LensFacts> lensFromExif(const Exif& exif, int width, int height);

/// The settings with the field of view of a lens of that focal length, so that Camera::focalLength() is `focalPixels`
/// to 1e-12: along the diagonal, or, where the projection cannot show that much, along the longer or the shorter side.
/// Throws std::invalid_argument where it cannot show even that, and for focal lengths not positive and finite.
CameraSettings withFocalLength(CameraSettings settings, double focalPixels);

}  // namespace parhelion
