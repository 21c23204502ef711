// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace parhelion {

/// How an angle theta from the optical axis becomes a distance r from the image's centre, in units of the focal length.
/// Each has its facts in a file of sky/projections/; sky/projections.h leads to them.
enum class Projection {
  rectilinear,           // r = tan theta
  fisheyeEqualArea,      // r = 2 sin(theta / 2)
  fisheyeEquidistant,    // r = theta
  fisheyeStereographic,  // r = 2 tan(theta / 2)
  fisheyeOrthographic,   // r = sin theta
  equirectangular,       // x = longitude, y = latitude of the camera's frame
};

/// All of them, in the enumeration's order.
std::span<const Projection> allProjections();

/// The projection's name as scene files and image attributes spell it, "fisheye-equal-area" for one.
std::string_view name(Projection projection);

/// The projection of that name, if it is one.
std::optional<Projection> projectionNamed(std::string_view word);

/// Whether the projection has an image circle.
bool isFisheye(Projection projection);

}  // namespace parhelion
