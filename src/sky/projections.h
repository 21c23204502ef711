// SPDX-License-Identifier: Apache-2.0
#pragma once

// Everything that tells one projection from another. A struct in sky/projections/ has the facts of one, and
// visitProjection() hands it to whoever asks. Lengths in the picture are in focal lengths, y up, from its centre;
// directions are unit vectors of the camera's frame: x to its right, y up, z along the optical axis.
//
// Each struct has
//   isFisheye             whether it has an image circle
//   isAzimuthal           whether the picture is alike all around the optical axis; only then may a lens distort it
//   isPanorama            whether x is longitude and y latitude of the camera's frame, so that a whole turn closes
//   isFlat                whether a direction is the sum of the axis and of what its column and its row bring, but for
//                         its length
//   showsHemispheres      whether it always shows one or two whole hemispheres: no field of view can be chosen
//   discs                 how many of them, side by side; each of two is a picture of the projection `ofDisc`
//   isMirrored            whether left and right are changed over, as from outside
//   fieldOfView           degrees that a picture can show along its width or diagonal
//   verticalFieldOfView   and along its height
//   hasDiagonal           whether a field of view along the diagonal makes sense
//   defaultFieldOfView, defaultElevation, defaultWidthPerHeight    of a scene that does not say; degrees
//   radiusAt(angle)       half the picture's extent for half a field of view
//   angleAt(radius)       its inverse; none beyond what the projection can show
//
// An azimuthal one has
//   radiusPerSine(v)      r / sin theta of a direction; for lanes too
//   atSquaredRadius(r2)   the angle theta that appears at a distance, given its square
//   circleHeight(r2)      1 - cos theta at a distance, given its square, without cancellation
//   edgeIntegral(c, a, b) the part of a straight edge in a pixel's solid angle, see camera_solid_angle.cpp, unless it
//                         has rectangle()
//
// The others have
//   place(v)              where a direction appears; for lanes too
//   direction(p)          its inverse; none where the picture shows no sky
//   anywhere(p)           the same going on smoothly there
//   rectangle(lo, hi)     solid angle (sr) of the part of the sky that a rectangle shows
//   latitudes(lo, hi), solidAngle(latitudes, lo, hi)    the same in two steps, of a panorama

#include <cassert>

#include "sky/projection.h"
#include "sky/projections/dual_fisheye.h"
#include "sky/projections/equal_area.h"
#include "sky/projections/equidistant.h"
#include "sky/projections/equirectangular.h"
#include "sky/projections/globe.h"
#include "sky/projections/orthographic.h"
#include "sky/projections/rectilinear.h"
#include "sky/projections/stereographic.h"

namespace parhelion {

/// What `visit` returns for the facts of the projection.
template <class Visitor>
PARHELION_INLINE constexpr auto visitProjection(Projection projection, const Visitor& visit) {
  switch (projection) {  // without default: the compiler asks for a case that is missing
    case Projection::rectilinear:
      return visit(projections::Rectilinear{});
    case Projection::fisheyeEqualArea:
      return visit(projections::EqualArea{});
    case Projection::fisheyeEquidistant:
      return visit(projections::Equidistant{});
    case Projection::fisheyeStereographic:
      return visit(projections::Stereographic{});
    case Projection::fisheyeOrthographic:
      return visit(projections::Orthographic{});
    case Projection::equirectangular:
      return visit(projections::Equirectangular{});
    case Projection::dualFisheyeEqualArea:
      return visit(projections::DualFisheye<projections::EqualArea, Projection::fisheyeEqualArea>{});
    case Projection::dualFisheyeEquidistant:
      return visit(projections::DualFisheye<projections::Equidistant, Projection::fisheyeEquidistant>{});
    case Projection::dualFisheyeStereographic:
      return visit(projections::DualFisheye<projections::Stereographic, Projection::fisheyeStereographic>{});
    case Projection::dualFisheyeOrthographic:
      return visit(projections::DualFisheye<projections::Orthographic, Projection::fisheyeOrthographic>{});
    case Projection::globe:
      return visit(projections::Globe{});
  }
  assert(false);
  __builtin_unreachable();
}

}  // namespace parhelion
