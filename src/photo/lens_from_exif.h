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

/// The focal length of a picture of `width` x `height` pixels, from the first of these that Exif has:
///
///   1. Focal length and focal-plane resolution. The latter is that of the picture that left the camera. How many
///      pixels this had is told by the maker's note, by Exif's size of the picture or by the picture itself, as long as
///      it makes a sensor of the camera's model or, where that is not known, a common one (known_sensors.h).
///   2. The 35 mm equivalent (CIPA DC-008: the same diagonal field of view on 36 mm x 24 mm film). It also comes before
///      the first where they are more than a fifth apart.
///   3. Focal length and the sensor of a known model.
///
/// A number of 0 is unknown. The picture may have been scaled and turned since. A digital zoom counts.
///
/// None where Exif has nothing of that. Throws std::invalid_argument naming the value where it cannot be (negative,
/// infinite, beyond all lenses), where no sensor fits, where a digital zoom may be in the 35 mm equivalent or not, and
/// where the picture has been cropped.
std::optional<LensFacts> lensFromExif(const Exif& exif, int width, int height);

/// The focal length, mm, that shows as much along the diagonal of 36 mm x 24 mm film as one of `focalPixels` shows
/// along that of the picture.
double equivalentOnFilm(double focalPixels, int width, int height);

/// The settings with the field of view of a lens of that focal length, so that Camera::focalLength() is `focalPixels`
/// to 1e-12: along the diagonal, or, where the projection cannot show that much, along the longer or the shorter side.
/// Throws std::invalid_argument where it cannot show even that, and for focal lengths not positive and finite.
CameraSettings withFocalLength(CameraSettings settings, double focalPixels);

}  // namespace parhelion
