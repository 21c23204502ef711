// SPDX-License-Identifier: Apache-2.0
#pragma once

// The keys of tables about the faces of crystals, as scene_keys.h has the others.

#include "scene/shape_kinds.h"

namespace parhelion {

template <class Visitor>
void visitKeys(Visitor& v, PyramidEndKeys& end) {
  v.key("height", kinds::Length{{0, 1}}, end.height, "Its height as a share of its full height.");
  v.key("slope", kinds::Optional{kinds::Length{{0, 90, true, true}, "degrees"}}, end.slope,
        "Angle between its faces and the c axis, degrees.");
  v.key("miller", kinds::Optional{kinds::Miller{}}, end.miller,
        "Miller indices [h, 0, -h, l] of its faces, in the place of a slope.");
}

template <class Visitor>
void visitKeys(Visitor& v, TiedSideKeys& sides) {
  constexpr Range kRange{-100, 100};
  v.key("twofold", kinds::Optional{kinds::Length{kRange}}, sides.twofold, "Opposite sides are drawn as one.");
  v.key("threefold", kinds::Optional{kinds::Length{kRange}}, sides.threefold,
        "Sides 3, 5 and 7 are drawn as one, and 4, 6 and 8.");
  v.key("sixfold", kinds::Optional{kinds::Length{kRange}}, sides.sixfold, "All sides are drawn as one.");
}

template <class Visitor>
void visitKeys(Visitor& v, Cavity& cavity) {
  v.key("depth", kinds::Number{{0, 2, false, true}}, cavity.depth,
        "Of the pit, as a share of half the prism's length: those of both ends add up to less than 2.");
  v.key("width", kinds::Number{{0, 1, true, true}}, cavity.width, "Of its rim, as a share of the prism's hexagon.");
}

template <class Visitor>
void visitKeys(Visitor& v, Cap& cap) {
  v.key("width", kinds::Number{{0, 100, true}}, cap.width, "Of the plate's hexagon, over the prism's.");
  v.key("aspect", kinds::Number{{kThinnestAspect, kLongestAspect}}, cap.aspect,
        "Of the plate by itself: its thickness over the distance between opposite vertices of its hexagon.");
}

template <class Visitor>
void visitKeys(Visitor& v, Notch& notch) {
  v.key("depth", kinds::Number{{0, 1, true, true}}, notch.depth,
        "Of a notch, as a share of the way from the side to the axis.");
  v.key("width", kinds::Number{{0, 1, true, true}}, notch.width,
        "Of its mouth, as a share of the side. With a width like the depth walls are parallel to prism faces.");
}

template <class Visitor>
void visitKeys(Visitor& v, PlaneKeys& plane) {
  v.key("normal", kinds::Optional{kinds::Direction{}}, plane.normal,
        "Direction that the face looks to, of any length: z along the c axis, x through the middle of a prism's face "
        "3.");
  v.key("distance", kinds::Number{{-1e6, 1e6}}, plane.distance, "Of the plane from the origin, in any unit.");
  v.key("face", kinds::Optional{kinds::WholeNumber{1, 999}}, plane.face,
        "Number of the face in raypaths; its place in the list when left out.");
}

}  // namespace parhelion
