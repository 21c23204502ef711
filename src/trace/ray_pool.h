// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

namespace parhelion {

/// The rays that are inside their crystals at the same time, as arrays. Places 0 ... active - 1 are taken.
///
/// The pool is small enough for the first-level cache. It is large enough that the processor has other lanes to work on
/// while the results of some are not yet there.
struct RayPool {
  static constexpr int kRoom = 128;
  template <class T>
  using Row = std::array<T, kRoom>;
  using Numbers = Row<double>;

  int active = 0;

  alignas(64) Numbers point[3];     // crystal frame, crystal units
  alignas(64) Numbers lightDir[3];  // unit, crystal frame
  alignas(64) Numbers energy;       // still inside; 0 in places not taken
  alignas(64) Numbers face;         // on which the ray starts
  alignas(64) Numbers order;        // internal encounters so far
  alignas(64) Numbers internalPath;
  alignas(64) Numbers pathState;                       // where PathRecord asks for it
  alignas(64) Row<std::uint64_t> pathFirst, pathLast;  // PathCode, likewise
  alignas(64) Row<std::uint64_t> random0, random1;     // state of PathRandom

  // Constant while the ray is in the pool.
  alignas(64) Numbers ray, stretch, iceIndex, perIceIndex;  // ray: RayQueue::ray(); perIceIndex: 1 / iceIndex
  alignas(64) Numbers splitAbove;                           // the path splits while it has at least this energy

  // What the engine found: the next face, or kNoFace; how far it is; the cosine of the ray's direction and its normal.
  alignas(64) Numbers nextFace, distance, cosine;

  // Of crystals that are not ideal, as in the queue.
  alignas(64) Numbers absorption, wave, absorbed;

  alignas(64) Numbers lost;  // energy of a ray for which no face was found, else 0

  // The places whose rays have ended, to be given to others.
  alignas(64) Numbers ended;
  int endedCount = 0;

  /// Moves a ray from one place to another.
  void move(int from, int to) {
    for (Numbers* rows : {point, lightDir})
      for (int k = 0; k < 3; ++k) rows[k][to] = rows[k][from];
    for (Numbers* row :
         {&energy, &face, &order, &internalPath, &ray, &stretch, &iceIndex, &perIceIndex, &splitAbove, &lost})
      (*row)[to] = (*row)[from];
    for (Row<std::uint64_t>* row : {&random0, &random1}) (*row)[to] = (*row)[from];
  }

  /// Moves what rays in crystals have that are not ideal, too.
  void moveOptics(int from, int to) {
    for (Numbers* row : {&absorption, &wave, &absorbed}) (*row)[to] = (*row)[from];
  }

  /// Moves what is kept of its path, too.
  void movePath(int from, int to) {
    pathState[to] = pathState[from];
    for (Row<std::uint64_t>* row : {&pathFirst, &pathLast}) (*row)[to] = (*row)[from];
  }
};

}  // namespace parhelion
