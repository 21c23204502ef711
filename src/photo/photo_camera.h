// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "photo/pointing.h"
#include "picture/photograph.h"
#include "sky/camera_settings.h"

namespace parhelion {

/// The camera that took a photograph, and the sun it saw.
struct PhotoCamera {
  CameraSettings camera;             // its size is the photograph's
  double sunElevation = 0.0;         // rad
  bool sunIsMeasured = false;        // its elevation follows from its place in the picture
  std::vector<std::string> remarks;  // how it was found: what a user should hold against what is known
};

/// What is known of a photograph's lens besides what its Exif tells.
struct LensClues {
  struct FieldOfView {
    FieldOfViewAxis axis;
    double angle;  // rad
  };

  Projection projection = Projection::rectilinear;
  std::optional<FieldOfView> fieldOfView;
  std::optional<double> focal35mm;    // mm, as on 35 mm film; where no field of view is known
  std::optional<double> imageCircle;  // rad
  Distortion distortion;
  Shift shift;
};

/// A photograph's camera before it is pointed: azimuth, elevation and roll are 0.
struct PhotoLens {
  CameraSettings camera;
  std::string remark;  // describeLens(), and where that is from if it was not known
};

/// The lens of a photograph: as the clues say, what they leave out from its Exif. An equirectangular picture without
/// field of view shows the whole sphere, a dual fisheye always does. None where nothing says how wide the lens saw.
/// Throws std::invalid_argument with a line of reason where what is said of it cannot be (lens_from_exif.h).
std::optional<PhotoLens> findLens(const Photograph& photograph, const LensClues& clues);

/// What is known of where a photograph's camera pointed, and of the sun. Places in pixels as PointingClue has them.
struct PointingClues {
  std::optional<Vec2> sun;
  std::vector<Vec2> horizon;                // points of it
  std::vector<PointingClue> known;          // places of known direction
  std::optional<double> roll;               // rad
  std::optional<double> sunElevation;       // rad, as it was
  std::optional<double> sceneSunElevation;  // rad, to be taken where neither that nor the picture itself tells
};

/// The camera of a photograph with its lens pointed so that the clues are where they are seen. The horizon of an
/// equirectangular picture without clues of known direction is its middle row. A single clue leaves the roll at 0
/// unless it is known. None where the sun's elevation stays unknown. Throws std::invalid_argument as findPointing()
/// does; its "clue 1", "clue 2" count the sun, then the horizon, then what is known.
std::optional<PhotoCamera> pointLens(const CameraSettings& lens, const PointingClues& clues);

/// How much a camera sees, in words: "lens: 5000.0 pixels, 39.6 degrees from left to right, 50 mm on 35 mm film".
std::string describeLens(const CameraSettings& camera);

/// Where a camera looks, in words: "camera: azimuth 12.000, elevation 20.000, roll 0.000 degrees, focal length ...".
std::string describePointing(const CameraSettings& camera);

}  // namespace parhelion
