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
  dualFisheyeEqualArea,  // two hemispheres side by side, each as by the fisheye of that name
  dualFisheyeEquidistant,
  dualFisheyeStereographic,
  dualFisheyeOrthographic,
  globe,  // r = sin theta, the sky as a ball seen from outside
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
    case Projection::dualFisheyeEqualArea:
      return "dual-fisheye-equal-area";
    case Projection::dualFisheyeEquidistant:
      return "dual-fisheye-equidistant";
    case Projection::dualFisheyeStereographic:
      return "dual-fisheye-stereographic";
    case Projection::dualFisheyeOrthographic:
      return "dual-fisheye-orthographic";
    case Projection::globe:
      return "globe";
  }
  return {};
}

/// Whether the picture ends at a circle, or at two.
bool isFisheye(Projection projection);

/// Whether the picture is a map of longitude and latitude, which closes upon itself after a full turn.
bool isPanorama(Projection projection);

/// Whether the picture always shows one or two whole hemispheres, so that it has no field of view of its own.
bool showsHemispheres(Projection projection);

/// How many hemispheres lie side by side; 1 where the picture is one whole.
int discs(Projection projection);

/// Whether the picture shows the sky from outside.
bool isMirrored(Projection projection);

}  // namespace parhelion
