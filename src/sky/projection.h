// SPDX-License-Identifier: Apache-2.0
#pragma once

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

/// The word for it in scene files and image attributes.
constexpr std::string_view nameOf(Projection projection) {
  switch (projection) {
    case Projection::rectilinear:
      return "rectilinear";
    case Projection::fisheyeEqualArea:
      return "fisheye-equal-area";
    case Projection::fisheyeEquidistant:
      return "fisheye-equidistant";
    case Projection::fisheyeStereographic:
      return "fisheye-stereographic";
    case Projection::fisheyeOrthographic:
      return "fisheye-orthographic";
    case Projection::equirectangular:
      return "equirectangular";
  }
  return {};
}

/// Whether the projection has an image circle.
bool isFisheye(Projection projection);

/// Whether the picture is a map of longitude and latitude, which closes upon itself after a full turn.
bool isPanorama(Projection projection);

}  // namespace parhelion
