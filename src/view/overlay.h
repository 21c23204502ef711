// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "sky/camera_settings.h"
#include "view/labels.h"
#include "view/line_art.h"

namespace parhelion {

struct OverlaySettings {
  double gridStep =
      radians(10);  // rad, between lines of equal altitude and azimuth, the sun's azimuth being 0; 0: none
  bool horizon = true;
  bool zenith = true;
  bool labels = true;
  std::vector<double> circles;  // rad, radii about the sun
  bool halos = false;           // haloForms()
  bool pyramids = false;        // pyramidRings()
  double scale = 1.0;  // of lines and letters; 1: letters are 1/50 of the picture's shorter side, at least 9 px
};

struct Overlay {
  LineArt lines;
  std::vector<PlacedLabel> labels;  // all inside the picture, no two of them overlapping
};

/// Lines and names over what a camera shows of the sky: the sun at `sunElevation` (rad) and azimuth 0, halos of ice of
/// refractive index `index`. A label that finds no room near its line is left out. Throws std::invalid_argument for a
/// grid of less than 0.1 degrees, for circles beyond (0, pi) and for a scale beyond [0.1, 20].
Overlay overlay(const CameraSettings& camera, double sunElevation, double index, const OverlaySettings& settings);

/// The lines alone.
inline LineArt drawOverlay(const CameraSettings& camera, double sunElevation, double index,
                           const OverlaySettings& settings) {
  return overlay(camera, sunElevation, index, settings).lines;
}

}  // namespace parhelion
