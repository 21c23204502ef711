// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "photo/sighting.h"

namespace parhelion {

/// Elevations in [-pi/2, pi/2] at which a camera of given roll sees `sighting` at its elevation: none, one or two.
std::vector<double> elevationsFor(const Sighting& sighting, double roll);

/// Range of elevations of the sky at which a camera of given roll can see a direction of its frame.
struct ElevationRange {
  double least, most;  // rad
};
ElevationRange elevationsSeen(const Vec3& inCamera, double roll);

/// Ways in which a camera may be turned to have made the sightings, among them all that fulfil them exactly: in closed
/// form from two directions, two elevations and an azimuth, or an elevation, an azimuth and the roll; else a scan of
/// all elevations and rolls in steps fine enough for least squares to start from. At least one sighting must have an
/// azimuth.
std::vector<CameraAngles> pointingStarts(std::span<const Sighting> sightings, std::optional<double> roll);

}  // namespace parhelion
