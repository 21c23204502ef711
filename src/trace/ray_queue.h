// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include "math/aligned_vector.h"
#include "optics/spectrum.h"

namespace parhelion {

/// The rays of one population that a wave traces, as arrays. A bundle has a place in the queue, and a ray of the bundle
/// is one of its members. What the members share is at the index `place` of each array. What each ray has for itself is
/// at the index ray(member, place).
struct RayQueue {
  using Row = AlignedVector<double>;

  /// Every array has room for this many more entries than are in use, because lanes are always written as a whole.
  static constexpr int kSpare = 8;

  explicit RayQueue(int bundleSize) : members(bundleSize) { makeRoom(0); }

  /// Makes room for so many bundles; false if there was room already. What the bundles share stays, what each ray has
  /// for itself is lost. A queue is as large as its population's rays need, since a cloud may have thousands of them.
  bool makeRoom(int bundles) {
    const int needed = static_cast<int>(std::bit_ceil(static_cast<unsigned>(bundles + kSpare)));
    if (needed <= room) return false;
    room = needed;
    for (auto* row : {&bundle, &random0, &random1}) row->resize(room);
    for (Row* rows : {crystalX, crystalY, crystalZ, lightWorld, lightCrystal, point})
      for (int k = 0; k < 3; ++k) rows[k].resize(room);
    for (Row* row : {&face, &stretch, &shadow, &weight}) row->resize(room);
    const std::size_t rays = static_cast<std::size_t>(room) * members;
    for (Row* row : {&iceIndex, &inside[0], &inside[1], &inside[2], &energy, &internalPath, &lost, &cutOff})
      row->resize(rays);
    light.resize(rays);
    return true;
  }

  int ray(int member, int place) const { return member * room + place; }
  int placeOf(int ray) const { return ray & (room - 1); }
  int memberOf(int ray) const { return ray / room; }

  int room = 0;   // a power of two
  int members;    // rays per bundle
  int count = 0;  // bundles in the queue

  AlignedVector<std::uint64_t> bundle;
  AlignedVector<std::uint64_t> random0, random1;  // state of PathRandom after the entry
  Row crystalX[3], crystalY[3], crystalZ[3];      // the crystal's axes in the world
  Row lightWorld[3], lightCrystal[3];             // unit, from the sun's disc toward the crystal
  Row point[3];                                   // of entry, crystal frame, crystal units
  Row face;                                       // of entry, index into the mesh's faces
  Row stretch;                                    // of the crystal along c
  Row shadow;                                     // the crystal's projected area, crystal units squared
  Row weight;                                     // intercepted light that a ray stands for

  // What each ray has for itself: first its light and its refractive index, then direction and energy of what enters
  // the crystal, then what became of it.
  std::vector<SpectralSample> light;
  Row iceIndex;
  Row inside[3], energy;
  Row internalPath;  // energy-weighted length inside the crystal, crystal units
  Row lost, cutOff;  // energy

  // Of crystals that are not ideal (CrystalOptics), of each ray: filled by Cloud::putOptics().
  Row absorption;  // per crystal unit
  Row wave;        // the wavelength, crystal units
  Row absorbed;    // energy
};

}  // namespace parhelion
