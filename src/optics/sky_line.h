// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "math/conventions.h"

namespace parhelion {

/// Neighbours on a line on the sky stand at most this far apart (rad): the great circle between them keeps within 1e-5
/// rad of a line that is curved no more than a circle of 13 degrees.
inline constexpr double kSkyLineStep = radians(0.25);

/// An unbroken line on the sky: unit world vectors, neighbours within kSkyLineStep.
using SkyLine = std::vector<Vec3>;

/// The point of a line at a parameter (rad), a unit world vector toward the sky; none where the line has a gap.
using SkyLocus = std::function<std::optional<Vec3>(double)>;

/// A line from one value of its parameter to another, in as many pieces as its gaps leave, their ends found to 1e-9 rad
/// of the parameter.
std::vector<SkyLine> followLocus(double from, double to, const SkyLocus& locus);

/// What of a line lies above the horizon, in as many pieces as that leaves.
std::vector<SkyLine> aboveHorizon(const SkyLine& line);

/// The circle of angular radius `radius` (rad) about a unit vector, closed, the last point being the first. It begins
/// above its centre and goes round clockwise as the observer sees it.
SkyLine circleAbout(const Vec3& centre, double radius);

}  // namespace parhelion
