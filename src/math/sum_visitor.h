// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "math/exact_sum.h"

namespace parhelion {

/// Is shown all exact integers of some sums, one after another, and may change them. The order is the same for all sums
/// of one kind and size, so the sums of several processes can be added integer by integer.
class SumVisitor {
 public:
  virtual ~SumVisitor() = default;

  virtual void visit(std::span<std::int64_t> sums) = 0;
  virtual void visit(std::uint64_t& count) = 0;
  virtual void visit(ExactSum::Units& sum) = 0;

  template <int kBits>
  void visit(FixedSum<kBits>& sum) {
    typename FixedSum<kBits>::Units units = sum.units();
    visit(units);
    sum = FixedSum<kBits>(units);
  }
};

}  // namespace parhelion
