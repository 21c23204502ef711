// SPDX-License-Identifier: Apache-2.0
#pragma once

// Part of lane_code.cpp, and of nothing else.

#include "optics/interface.h"
#include "sky/sky_view.h"
#include "trace/lane_types.h"

namespace parhelion {
namespace {

void turnToWorld(const RayQueue& queue, ExitList& exits) {
  const Words placeBits = Words{} + static_cast<std::uint64_t>(queue.room - 1);
  for (int i = 0; i < exits.count; i += kLanes) {
    // The last digits of a ray's number are its place.
    const Words ray = bitsAs<Words>(load<Real>(&exits.ray[i]) + 0x1p52) & placeBits;
    const Real place = bitsAs<Real>(ray | bitsAs<Words>(Real{} + 0x1p52)) - 0x1p52;
    const Triple<Real> d = loadTriple(exits.lightDirCrystal, i);
    const Triple<Real> world =
        renormalised(d.x * lookUpTriple(queue.crystalX, place) + d.y * lookUpTriple(queue.crystalY, place) +
                     d.z * lookUpTriple(queue.crystalZ, place));
    const Mask undeviated = isSameDirection<Real>(world, lookUpTriple(queue.lightWorld, place));
    storeTriple(exits.lightDirWorld, i, world);
    store(&exits.undeviated[i], select(undeviated, all<Real>(1.0), Real{}));
  }
}

/// What becomes of exits in one group of lanes, where `which` says so: appends those that are seen.
template <bool kBothViews, class Facts>
PARHELION_INLINE void seeGroup(Facts facts, const SkyView& view, const Triple<Real>& toSky, const Mask& which,
                               const Real& exit, const Real& ray, SeenLight& seen) {
  const auto pixelAt = [&](const PicturePlace<Real>& at, const Mask& isThere) __attribute__((always_inline)) {
    return select(isThere, wholePart(at.y) * view.lens.width + wholePart(at.x), all<Real>(SeenLight::kNowhere));
  };
  if constexpr (kBothViews) {
    const auto [place, mirrored] = view.projectBoth(facts, toSky, which);
    const Mask inside = place.inside & which, mirroredInside = mirrored.inside & which;
    const Compress<Real> kept(inside | mirroredInside);
    kept.store(&seen.exit[seen.count], exit);
    kept.store(&seen.ray[seen.count], ray);
    kept.store(&seen.pixel[seen.count], pixelAt(place, inside));
    kept.store(&seen.mirroredPixel[seen.count], pixelAt(mirrored, mirroredInside));
    seen.count += kept.count();
  } else {
    const PicturePlace<Real> place = view.lens.projectFrame(facts, view.lens.inFrame(toSky));
    const Mask inside = place.inside & which;
    const Compress<Real> kept(inside);
    kept.store(&seen.exit[seen.count], exit);
    kept.store(&seen.ray[seen.count], ray);
    kept.store(&seen.pixel[seen.count], pixelAt(place, inside));
    seen.count += kept.count();
  }
}

/// Of the exits from place i on, those that the observer may see.
template <bool kBothViews, class Facts>
PARHELION_INLINE Mask mayBeSeen(Facts facts, const SkyView& view, const Triple<Real>& toSky, const ExitList& exits,
                                int i) {
  const Mask real = below(i, exits.count) & (load<Real>(&exits.undeviated[i]) == 0.0) & view.lens.isAbove(toSky);
  if constexpr (!kBothViews) return real & view.mayShow(facts, toSky);
  return real & view.mayShowEither(facts, toSky);
}

/// LaneSteps::see through a projection whose pictures show most of the sky, or nothing but what they may show.
template <bool kBothViews, class Facts>
PARHELION_INLINE void seeAll(Facts facts, const SkyView& view, const ExitList& exits, SeenLight& seen) {
  seen.count = 0;
  for (int i = 0; i < exits.count; i += kLanes) {
    const Triple<Real> toSky = -loadTriple(exits.lightDirWorld, i);
    const Mask which = mayBeSeen<kBothViews>(facts, view, toSky, exits, i);
    if (anyOf(which))
      seeGroup<kBothViews>(facts, view, toSky, which, counting() + static_cast<double>(i), load<Real>(&exits.ray[i]),
                           seen);
  }
}

/// LaneSteps::see through a projection whose pictures show little of the sky. Among several lanes there is nearly
/// always one that may be seen. So those are brought together first, and the others are spared the rest.
template <bool kBothViews, class Facts>
PARHELION_INLINE void seeFew(Facts facts, const SkyView& view, const ExitList& exits, SeenLight& seen) {
  int few = 0;
  for (int i = 0; i < exits.count; i += kLanes) {
    const Mask which = mayBeSeen<kBothViews>(facts, view, -loadTriple(exits.lightDirWorld, i), exits, i);
    const Compress<Real> kept(which);
    kept.store(&seen.exit[few], counting() + static_cast<double>(i));
    few += kept.count();
  }
  seen.count = 0;
  for (int i = 0; i < few; i += kLanes) {
    const Mask which = below(i, few);
    // What is seen is written over what was read before.
    const Real exit = select(which, load<Real>(&seen.exit[i]), Real{});
    seeGroup<kBothViews>(facts, view, -lookUpTriple(exits.lightDirWorld, exit), which, exit,
                         lookUp(exits.ray.data(), exit), seen);
  }
}

template <bool kBothViews, class Facts>
PARHELION_INLINE void seeThrough(Facts facts, const SkyView& view, const ExitList& exits, SeenLight& seen) {
  if constexpr (facts.isAzimuthal && !facts.isFisheye)
    seeFew<kBothViews>(facts, view, exits, seen);
  else
    seeAll<kBothViews>(facts, view, exits, seen);
}

void see(const SkyView& view, bool bothViews, const ExitList& exits, SeenLight& seen) {
  visitProjection(view.lens.projection, [&](auto facts) {
    if (bothViews)
      seeThrough<true>(facts, view, exits, seen);
    else
      seeThrough<false>(facts, view, exits, seen);
  });
}

}  // namespace
}  // namespace parhelion
