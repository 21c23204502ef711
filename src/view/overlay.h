// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "optics/halo_makers.h"
#include "sky/camera_settings.h"
#include "view/labels.h"
#include "view/line_art.h"

namespace parhelion {

/// A name for a place of the picture, pixel coordinates.
struct NamedPlace {
  std::string text;
  Vec2 at;
};

struct OverlaySettings {
  // Between lines of equal altitude and azimuth, the sun's azimuth being 0, rad. 0: none; left out: 10 degrees, or 30
  // where lines would stand too close.
  std::optional<double> gridStep;
  bool horizon = true;
  bool zenith = true;
  bool labels = true;
  std::vector<double> circles;  // rad, radii about the sun
  bool halos = false;           // haloForms() of the makers; in small pictures without the rare ones
  std::vector<HaloMaker> makers = allHaloMakers();
  bool belowHorizon = true;       // draw there, too
  std::vector<NamedPlace> names;  // with labels: in place of the names of halos
  bool onPaper = false;           // in dark colours, for dots on white
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
