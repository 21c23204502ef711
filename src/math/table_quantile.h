// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "math/lanes.h"

namespace parhelion {

/// The inverse of a tabulated density's cumulative distribution, as plain numbers that lanes can run on: a view into a
/// TabulatedDensity, valid as long as that is.
struct TableQuantile {
  double lo, step;
  int cells;
  const double* density;     // at the cells + 1 nodes, normalised
  const double* cumulative;  // at the nodes, from 0 to 1
  const double* guide;       // guide[k]: the cell in which cumulative k / cells lies

  /// The value below which a fraction `u` in [0, 1] of the probability lies.
  template <class T>
  PARHELION_INLINE T at(const T& u) const {
    const double last = cells - 1.0;
    T cell = lookUp(guide, wholePart(u * static_cast<double>(cells)));
    // The guide leaves a step or two to go.
    for (MaskOf<T> low = (cell < last) & (lookUp(cumulative + 1, cell) <= u); anyOf(low);
         low = (cell < last) & (lookUp(cumulative + 1, cell) <= u))
      cell = select(low, cell + 1.0, cell);

    // Solve d0 t + (d1 - d0) t^2 / 2 = v for the fraction t of the cell, in the form that does not cancel.
    const T d0 = lookUp(density, cell), d1 = lookUp(density + 1, cell);
    const T v = higher((u - lookUp(cumulative, cell)) / step, T{});
    const T sum = d0 + squareRoot(higher(d0 * d0 + 2.0 * (d1 - d0) * v, T{}));
    const T t = select(sum > 0.0, 2.0 * v / sum, T{});
    return lo + (cell + lower(t, all<T>(1.0))) * step;
  }
};

}  // namespace parhelion
