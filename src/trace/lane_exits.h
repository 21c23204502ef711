// SPDX-License-Identifier: Apache-2.0
#pragma once

// Part of lane_code.cpp, and of nothing else.

#include "optics/interface.h"
#include "sky/lens.h"
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

/// LaneSteps::see through the projection of these facts.
template <bool kBothViews, class Facts>
PARHELION_INLINE void seeThrough(Facts facts, const Lens& lens, const ExitList& exits, SeenLight& seen) {
  int count = 0;
  for (int i = 0; i < exits.count; i += kLanes) {
    const Triple<Real> toSky = -loadTriple(exits.lightDirWorld, i);
    const Mask real = below(i, exits.count) & (load<Real>(&exits.undeviated[i]) == 0.0) & lens.isAbove(toSky);
    const auto [v, mirrored] = lens.bothInFrame(toSky);
    Mask hope = lens.mayShow(facts, v);
    if constexpr (kBothViews) hope = hope | lens.mayShow(facts, mirrored);
    if (!anyOf(hope & real)) continue;

    const PicturePlace<Real> place = lens.projectFrame(facts, v);
    const Mask inside = place.inside & real;
    Mask anywhere = inside, mirroredInside{};
    PicturePlace<Real> mirroredPlace{};
    if constexpr (kBothViews) {
      mirroredPlace = lens.projectFrame(facts, mirrored);
      mirroredInside = mirroredPlace.inside & real;
      anywhere = inside | mirroredInside;
    }
    const auto pixelAt = [&](const PicturePlace<Real>& at, const Mask& isThere) __attribute__((always_inline)) {
      return select(isThere, wholePart(at.y) * lens.width + wholePart(at.x), all<Real>(SeenLight::kNowhere));
    };
    const Compress<Real> kept(anywhere);
    kept.store(&seen.exit[count], counting() + static_cast<double>(i));
    kept.store(&seen.ray[count], load<Real>(&exits.ray[i]));
    kept.store(&seen.pixel[count], pixelAt(place, inside));
    if constexpr (kBothViews) kept.store(&seen.mirroredPixel[count], pixelAt(mirroredPlace, mirroredInside));
    count += kept.count();
  }
  seen.count = count;
}

void see(const Camera& camera, bool bothViews, const ExitList& exits, SeenLight& seen) {
  const Lens lens = camera.lens();
  visitProjection(lens.projection, [&](auto facts) {
    if (bothViews)
      seeThrough<true>(facts, lens, exits, seen);
    else
      seeThrough<false>(facts, lens, exits, seen);
  });
}

}  // namespace
}  // namespace parhelion
