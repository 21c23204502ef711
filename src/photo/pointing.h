// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "math/conventions.h"
#include "sky/camera_settings.h"

namespace parhelion {

/// What is known of one place in a photograph: where in the sky it points. A point of the horizon has elevation 0 and
/// no azimuth; the sun has azimuth 0, and its elevation if that is known.
struct PointingClue {
  Vec2 pixel;  // upright picture, x right, y down, centre of the first pixel (0.5, 0.5); may lie outside
  std::optional<double> azimuth;    // rad, from the sun, positive to the right
  std::optional<double> elevation;  // rad
};

/// How far the camera found is from one clue.
struct PointingResidual {
  double angle;   // rad, on the sky: what azimuth and elevation are off together
  double pixels;  // the same in the picture: from the clue's place to where (or, of a horizon, to the line on which) it
                  // belongs
};

struct Pointing {
  double azimuth, elevation, roll;          // rad, as in CameraSettings
  std::vector<PointingResidual> residuals;  // in the order of the clues

  /// Root mean squares over the clues.
  double rmsAngle() const;  // rad
  double rmsPixels() const;
};

/// Where a camera of known lens pointed. `lens` has projection, field of view, distortion and size; its own azimuth,
/// elevation and roll do not matter. With `roll` given that is kept exactly. The clues, and the roll, must determine
/// the three angles: one full direction and a roll, two full directions, or two elevations and one azimuth, for
/// instance. Closed form where the clues just suffice, else the least sum of squared angles on the sky (least squares
/// from the closed form of the best part of the clues). Where two cameras fulfil the clues equally well, to a pixel, it
/// is with a given roll the one that points nearer to the horizon, else the one that is held upright: the zenith toward
/// the upper side of the picture. Throws std::invalid_argument with one line of reason where the clues do not determine
/// the angles, where two of them coincide, where no camera with that roll comes within a degree of what is to be seen
/// there, and where the best camera is more than five degrees off one of them.
Pointing findPointing(const CameraSettings& lens, std::span<const PointingClue> clues,
                      std::optional<double> roll = std::nullopt);

}  // namespace parhelion
