// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "math/conventions.h"
#include "sky/camera_settings.h"

namespace parhelion {

/// What is known of one place in a photograph: the sky point that is seen there, or one of its two angles. A point of
/// the horizon has elevation 0 and no azimuth. The sun has azimuth 0, and its elevation if that is known.
struct PointingClue {
  Vec2 pixel;  // in the upright picture; x right, y down, first pixel's centre (0.5, 0.5); may lie outside
  std::optional<double> azimuth;    // rad, from the sun, positive to the right
  std::optional<double> elevation;  // rad
};

/// By how much the camera that was found misses one clue.
struct PointingResidual {
  double angle;   // rad, on the sky, by azimuth and elevation together
  double pixels;  // the same in the picture: from the clue's place to the right place, or to the right line where only
                  // one of the angles is known
};

struct Pointing {
  double azimuth, elevation, roll;          // rad, as in CameraSettings
  std::vector<PointingResidual> residuals;  // in the order of the clues

  /// Root mean squares of the residuals over the clues.
  double rmsAngle() const;  // rad
  double rmsPixels() const;
};

/// Finds where a camera with a known lens pointed. `lens` gives projection, field of view, distortion and size; its own
/// azimuth, elevation and roll are ignored. If `roll` is given, it is kept exactly.
///
/// The clues, and the roll if given, must determine the camera's three angles. Enough are, for instance, one full
/// direction and a roll, two full directions, or two elevations and one azimuth. Where the clues just suffice, the
/// answer is in closed form. Where there are more, it has the least sum of squared angles on the sky, by least squares
/// that start from the closed form of the best part of the clues.
///
/// Two cameras may fulfil the clues equally well, to a pixel. If `roll` is given, the answer is then the one that
/// points nearer to the horizon. If not, it is the one held upright, with the zenith toward the upper side of the
/// picture.
///
/// Throws std::invalid_argument, with one line of reason,
///   - where the clues do not determine the angles,
///   - where two of them coincide,
///   - where no camera with that roll comes within a degree of what is to be seen there,
///   - where the best camera is more than five degrees off one of them.
Pointing findPointing(const CameraSettings& lens, std::span<const PointingClue> clues,
                      std::optional<double> roll = std::nullopt);

}  // namespace parhelion
