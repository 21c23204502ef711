// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include "photo/sighting.h"

namespace parhelion {

/// A camera turned so that it misses its sightings by the least sum of squares.
struct PointingFit {
  CameraAngles angles;
  MissSum sum;  // where the roll is given, of the turns that keep it: the others count as determined
};

/// The best of all cameras, with that roll if it is given; of several whose root mean square is within `pixelAngle`
/// (rad) of the best the one nearest to the horizon if the roll is given, else the one that is held upright. At least
/// one sighting must have an azimuth.
PointingFit fitPointing(std::span<const Sighting> sightings, std::optional<double> roll, double pixelAngle);

}  // namespace parhelion
