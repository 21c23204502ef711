// SPDX-License-Identifier: Apache-2.0
#include "photo/halo_camera.h"

#include <algorithm>

#include "photo/lens_from_exif.h"
#include "sky/camera.h"

namespace parhelion {

CameraSettings haloCamera(const CameraSettings& photo, int coarseness) {
  if (isPanorama(photo.projection) || showsHemispheres(photo.projection)) {
    const int width = photo.width / discs(photo.projection);
    while (width % coarseness != 0 || photo.height % coarseness != 0) --coarseness;
  }
  CameraSettings camera = photo;
  camera.width = (photo.width + coarseness - 1) / coarseness;
  camera.height = (photo.height + coarseness - 1) / coarseness;
  if (camera.width * coarseness == photo.width && camera.height * coarseness == photo.height) return camera;
  return withFocalLength(camera, Camera(photo).focalLength() / coarseness);
}

int finestNeeded(const CameraSettings& photo, double sunDiameter) {
  constexpr double kPixelsADisc = 10.0;
  return std::max(1, static_cast<int>(sunDiameter / kPixelsADisc * Camera(photo).focalLength()));
}

}  // namespace parhelion
