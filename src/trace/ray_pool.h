// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

namespace parhelion {

/// The rays that are inside their crystals at a time, as arrays: places 0 ... active - 1 are taken. Small enough for
/// the first-level cache, long enough that waiting for one group's numbers is spent on the next.
struct RayPool {
  static constexpr int kRoom = 128;
  template <class T>
  using Row = std::array<T, kRoom>;
  using Numbers = Row<double>;

  int active = 0;

  alignas(64) Numbers point[3];     // crystal frame, crystal units
  alignas(64) Numbers lightDir[3];  // unit, crystal frame
  alignas(64) Numbers energy;       // still inside; 0 in places not taken
  alignas(64) Numbers face;         // the one the ray starts on
  alignas(64) Numbers order;        // internal encounters so far
  alignas(64) Numbers internalPath;
  alignas(64) Row<std::uint64_t> random0, random1;  // state of PathRandom

  // As the ray came: constant while it is here.
  alignas(64) Numbers ray, stretch, iceIndex, perIceIndex;
  alignas(64) Numbers splitAbove;  // energy from which a path splits

  // What the engine found: the next face, or kNoFace.
  alignas(64) Numbers nextFace, distance, cosine;

  alignas(64) Numbers lost;  // energy of a ray for which no face was found, else 0

  // Places whose ray is at its end.
  alignas(64) Numbers ended;
  int endedCount = 0;

  /// Takes over the ray at another place.
  void move(int from, int to) {
    for (Numbers* rows : {point, lightDir})
      for (int k = 0; k < 3; ++k) rows[k][to] = rows[k][from];
    for (Numbers* row :
         {&energy, &face, &order, &internalPath, &ray, &stretch, &iceIndex, &perIceIndex, &splitAbove, &lost})
      (*row)[to] = (*row)[from];
    random0[to] = random0[from];
    random1[to] = random1[from];
  }
};

}  // namespace parhelion
