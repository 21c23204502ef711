// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "math/aligned_vector.h"
#include "math/conventions.h"
#include "trace/path_record.h"

namespace parhelion {

/// Light that leaves crystals, as arrays: entry i of each belongs to exit i. In no particular order.
struct ExitList {
  PathRecord record = PathRecord::nothing;
  int count = 0;
  AlignedVector<double> lightDirCrystal[3];
  AlignedVector<double> lightDirWorld[3];  // unit; from lightDirCrystal, when all have left
  AlignedVector<double> energy;            // of the light its ray stands for
  AlignedVector<double> ray;               // whose it is, RayQueue::ray()
  AlignedVector<double> order;             // 0: reflected at the outside; k: left at internal encounter k
  AlignedVector<double> undeviated;        // 1 for light that goes on as if there were no crystal, else 0

  // Of the path up to here, where PathRecord asks for it.
  AlignedVector<double> pathState;                   // of the population's automaton
  AlignedVector<std::uint64_t> pathFirst, pathLast;  // PathCode; there are order + 1 faces
  std::vector<int> layer;                            // PathPlan::layerOf(), where there are layers

  Vec3 lightDir(int exit) const { return {lightDirWorld[0][exit], lightDirWorld[1][exit], lightDirWorld[2][exit]}; }

  /// Moves an exit within the list, before there are world directions and layers.
  void move(int from, int to) {
    for (AlignedVector<double>& row : lightDirCrystal) row[to] = row[from];
    for (AlignedVector<double>* row : {&energy, &ray, &order, &pathState}) (*row)[to] = (*row)[from];
    if (record != PathRecord::sequence) return;
    for (AlignedVector<std::uint64_t>* row : {&pathFirst, &pathLast}) (*row)[to] = (*row)[from];
  }

  /// Makes room for so many more.
  void reserve(int more) {
    const std::size_t room = static_cast<std::size_t>(count + more);
    if (energy.size() >= room) return;
    for (AlignedVector<double>* rows : {lightDirCrystal, lightDirWorld})
      for (int k = 0; k < 3; ++k) rows[k].resize(2 * room);
    for (AlignedVector<double>* row : {&energy, &ray, &order, &undeviated}) row->resize(2 * room);
    if (record == PathRecord::nothing) return;
    pathState.resize(2 * room);
    if (record == PathRecord::state) return;
    for (AlignedVector<std::uint64_t>* row : {&pathFirst, &pathLast}) row->resize(2 * room);
  }
};

}  // namespace parhelion
