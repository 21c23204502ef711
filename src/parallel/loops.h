// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "parallel/loop_order.h"

// What a loop's function writes must depend on its argument alone: then the bits are the same for any number of
// threads.

namespace parhelion {

/// Calls f(i) for i = 0 ... count - 1 in parallel, each call being work enough for a thread.
template <class Index, class F>
void forEach(Index count, const F& f) {
  LoopOrder order;
  tbb::parallel_for(Index{0}, count, order.around(f));
}

/// Calls f(y) for y = 0 ... height - 1 in parallel, several rows to a piece of work.
template <class F>
void forRows(int height, const F& f) {
  constexpr int kRows = 8;  // at least, in a piece
  LoopOrder order;
  const auto ofRows = [&](const auto& rows) {
    for (int y = rows.begin(); y != rows.end(); ++y) f(y);
  };
  tbb::parallel_for(tbb::blocked_range<int>(0, height, kRows), order.around(ofRows));
}

/// The sum of f(y), a number or a vector, over all rows: rows in parallel, the sum itself in their order.
template <class F>
auto sumOverRows(int height, const F& f) {
  std::vector<decltype(f(0))> sums(static_cast<std::size_t>(height));
  forRows(height, [&](int y) { sums[static_cast<std::size_t>(y)] = f(y); });
  decltype(f(0)) total{};
  for (const auto& sum : sums) total += sum;
  return total;
}

}  // namespace parhelion
