// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "math/aligned_vector.h"
#include "math/conventions.h"

namespace parhelion {

/// Light that leaves crystals, as arrays: entry i of each belongs to exit i. In no particular order.
struct ExitList {
  int count = 0;
  AlignedVector<double> lightDirCrystal[3];
  AlignedVector<double> lightDirWorld[3];  // unit; from lightDirCrystal, when all have left
  AlignedVector<double> energy;            // of the light its ray stands for
  AlignedVector<double> ray;               // whose it is, RayQueue::ray()
  AlignedVector<double> order;             // 0: reflected at the outside; k: left at internal encounter k
  AlignedVector<double> undeviated;        // 1 for light that goes on as if there were no crystal, else 0

  Vec3 lightDir(int exit) const { return {lightDirWorld[0][exit], lightDirWorld[1][exit], lightDirWorld[2][exit]}; }

  /// Makes room for so many more.
  void reserve(int more) {
    const std::size_t room = static_cast<std::size_t>(count + more);
    if (energy.size() >= room) return;
    for (AlignedVector<double>* rows : {lightDirCrystal, lightDirWorld})
      for (int k = 0; k < 3; ++k) rows[k].resize(2 * room);
    for (AlignedVector<double>* row : {&energy, &ray, &order, &undeviated}) row->resize(2 * room);
  }
};

}  // namespace parhelion
