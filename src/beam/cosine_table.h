// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "math/aligned_vector.h"
#include "math/inline.h"

namespace parhelion {

/// Eight floats side by side.
using EightFloats [[gnu::vector_size(32)]] = float;

/// Cosines of whole numbers of waves around a ring, for rings that are the same on both sides.
///
/// Half a ring is cut into cells of equal angle. An order is a number of waves. Of a ring there are even and odd orders
/// by themselves, as many of each: to the other quarter of the ring these are the same, and the opposite.
class CosineTable {
 public:
  /// An even number of cells.
  explicit CosineTable(int cells);

  int cells() const { return cells_; }

  /// Orders of each parity that are kept where `orders` are wanted: whole groups of eight, and no more than cells.
  int room(double orders) const;

  /// Two cells as far from either end of the half ring, by the sum and the difference of what they have in each
  /// channel.
  template <int C>
  struct CellPair {
    int cell;  // the first
    std::array<float, C> sum, difference;
  };

  /// Adds to `orders` the sums over the cells of what they have times cos(order * angle of the cell's middle): for each
  /// channel the even orders, then the odd ones, room of each.
  template <int C>
  void analyse(const std::vector<CellPair<C>>& pairs, int room, float* orders) const;

  /// What the cells have: the sums over the orders of their number times that cosine, in each of C channels. `cells`
  /// has four floats for each.
  template <int C>
  void synthesise(const float* orders, int room, float* cells) const;

 private:
  int cells_, most_;                    // orders of each parity
  AlignedVector<EightFloats> byCell_;   // by parity, group of eight orders and cell: a group
  AlignedVector<EightFloats> byOrder_;  // by parity, group of eight cells and order: a group
};

}  // namespace parhelion
