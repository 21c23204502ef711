// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include "math/aligned_vector.h"
#include "optics/spectrum.h"

namespace parhelion {

/// Rays of one population as arrays: all that the rays of a bundle share is at the bundle's place of each, and what a
/// ray has for itself is at ray(member, place).
struct RayQueue {
  using Row = AlignedVector<double>;

  /// Every array has this much room behind what is in use, so that whole lanes can be written.
  static constexpr int kSpare = 8;

  RayQueue(int bundles, int bundleSize)
      : room(static_cast<int>(std::bit_ceil(static_cast<unsigned>(bundles + kSpare)))), members(bundleSize) {
    for (auto* row : {&bundle, &random0, &random1}) row->resize(room);
    for (Row* rows : {crystalX, crystalY, crystalZ, lightWorld, lightCrystal, point})
      for (int k = 0; k < 3; ++k) rows[k].resize(room);
    for (Row* row : {&face, &stretch, &shadow, &weight}) row->resize(room);
    const std::size_t rays = static_cast<std::size_t>(room) * members;
    for (Row* row : {&iceIndex, &inside[0], &inside[1], &inside[2], &energy, &internalPath, &lost, &cutOff})
      row->resize(rays);
    light.resize(rays);
  }

  int ray(int member, int place) const { return member * room + place; }
  int placeOf(int ray) const { return ray & (room - 1); }

  int room;       // a power of two
  int members;    // rays a bundle
  int count = 0;  // bundles

  AlignedVector<std::uint64_t> bundle;
  AlignedVector<std::uint64_t> random0, random1;  // state of PathRandom behind the entry
  Row crystalX[3], crystalY[3], crystalZ[3];      // the crystal's axes in the world
  Row lightWorld[3], lightCrystal[3];             // unit, from the sun's disc toward the crystal
  Row point[3];                                   // of entry, crystal frame, crystal units
  Row face;                                       // of entry, index into the mesh's faces
  Row stretch;                                    // of the crystal along c
  Row shadow;                                     // the crystal's projected area, crystal units squared
  Row weight;                                     // intercepted light a ray stands for

  // A ray's own: its wavelength and what the ice makes of it, then what enters the crystal, then what became of it.
  std::vector<SpectralSample> light;
  Row iceIndex;
  Row inside[3], energy;
  Row internalPath;  // energy-weighted length inside the crystal, crystal units
  Row lost, cutOff;  // energy
};

}  // namespace parhelion
