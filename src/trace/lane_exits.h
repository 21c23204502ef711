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

void see(const Camera& camera, bool mirrored, const ExitList& exits, SeenLight& seen) {
  const Lens lens = camera.lens();
  const double side = mirrored ? 1.0 : -1.0;
  for (int i = 0; i < exits.count; i += kLanes) {
    const Triple<Real> light = loadTriple(exits.lightDirWorld, i);
    const auto place = lens.project<Real>({-light.x, side * light.y, -light.z});
    const Mask real = below(i, exits.count) & (load<Real>(&exits.undeviated[i]) == 0.0);
    const Compress<Real> inside(place.inside & real);
    inside.store(&seen.pixel[seen.count], wholePart(place.y) * lens.width + wholePart(place.x));
    inside.store(&seen.exit[seen.count], counting() + static_cast<double>(i));
    inside.store(&seen.ray[seen.count], load<Real>(&exits.ray[i]));
    seen.count += inside.count();
  }
}

}  // namespace
}  // namespace parhelion
