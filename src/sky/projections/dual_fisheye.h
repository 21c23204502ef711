// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sky/projection.h"
#include "sky/projections/common.h"

namespace parhelion::projections {

/// The whole sky as two discs that touch, each half of it through a fisheye of its own: at the left what lies before
/// the camera, at the right what it sees after half a turn about its up. Where they touch, both show the same place.
template <class FisheyeFacts, Projection kEach>
struct DualFisheye : FisheyeFacts {
  static constexpr bool showsHemispheres = true, hasDiagonal = false;
  static constexpr int discs = 2;
  static constexpr Projection ofDisc = kEach;
  static constexpr Range fieldOfView{0, 180, true}, verticalFieldOfView = fieldOfView;
  static constexpr int defaultWidthPerHeight = 2;
};

}  // namespace parhelion::projections
