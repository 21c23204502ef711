// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sky/lens.h"

namespace parhelion {

class Camera;

/// A camera's lens, with what makes it quick to say of many directions, and of their mirror images in the sun's
/// vertical plane, whether and where they are in the picture. The places are those of the lens, to the bit.
struct SkyView {
  explicit SkyView(const Camera& camera);

  Lens lens;
  double leastCosine;  // of angles from the axis in a picture of one disc, up to its corners
  bool isUpright;      // whether the camera's up is the zenith

  // Of an upright panorama, pixels.
  double fullTurn;
  double mirrorSum;  // of the x of a place and of its mirror image
  double rounding;   // far more than rounding brings to a place

  /// Whether a direction may be in the picture: a quick answer that is right where it is no.
  template <class Facts, class T>
  PARHELION_INLINE MaskOf<T> mayShow(Facts facts, const Triple<T>& toSky) const {
    if constexpr (facts.isAzimuthal && facts.discs == 1)
      return lens.inFrame(toSky).z >= leastCosine;
    else
      return toSky.z == toSky.z;
  }

  /// The same of a direction or its mirror image.
  template <class Facts, class T>
  PARHELION_INLINE MaskOf<T> mayShowEither(Facts facts, const Triple<T>& toSky) const {
    if constexpr (facts.isAzimuthal && facts.discs == 1) {
      const auto [v, mirrored] = lens.bothInFrame(toSky);
      return (v.z >= leastCosine) | (mirrored.z >= leastCosine);
    } else {
      return toSky.z == toSky.z;
    }
  }

  /// Where a direction and its mirror image appear, of the lanes of `which`.
  template <class Facts, class T>
  PARHELION_INLINE std::pair<PicturePlace<T>, PicturePlace<T>> projectBoth(Facts facts, const Triple<T>& toSky,
                                                                           const MaskOf<T>& which) const {
    const auto [v, mirrored] = lens.bothInFrame(toSky);
    const PicturePlace<T> place = lens.projectFrame(facts, v);
    if constexpr (facts.isPanorama) {
      // If its poles are zenith and nadir, a place and its mirror image are in the same row, and their columns add up
      // to the same number. This spares the second view its arc tangents.
      if (isUpright) {
        const PicturePlace<T> image = reflected(place);
        if (!anyOf(which & mayBeOff(image, v))) return {place, image};
      }
    }
    return {place, lens.projectFrame(facts, mirrored)};
  }

 private:
  /// The mirror image of a place in an upright panorama, but for rounding.
  template <class T>
  PARHELION_INLINE PicturePlace<T> reflected(const PicturePlace<T>& place) const {
    const T x = mirrorSum - place.x, fromCentre = x - lens.centreX;
    const T back = select(fromCentre > 0.5 * fullTurn, all<T>(-fullTurn), T{});
    return lens.withinBorders<T>(
        {place.y == place.y, x + select(fromCentre < -0.5 * fullTurn, all<T>(fullTurn), back), place.y});
  }

  /// Whether rounding may have brought a mirror image of reflected() into another pixel than its own direction is in;
  /// `v` is the place's direction in the camera's frame.
  template <class T>
  PARHELION_INLINE MaskOf<T> mayBeOff(const PicturePlace<T>& image, const Triple<T>& v) const {
    // The poles have no longitude of their own.
    return isNearBorder(image.x) | isNearBorder(image.y) | (v.x * v.x + v.z * v.z == 0.0);
  }
  template <class T>
  PARHELION_INLINE MaskOf<T> isNearBorder(const T& at) const {
    const T off = at - nearest(at);
    return (off < rounding) & (off > -rounding);
  }
};

}  // namespace parhelion
