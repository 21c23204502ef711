// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "math/exact_sum.h"

namespace parhelion {

/// Where the light goes that falls on a cloud, by how often it was scattered, in units of the light of one walk.
/// in = direct + all above + all below + absorbed + leftOut + cutOff + drawn, to rounding.
struct OrderLedger {
  /// Orders told one by one; all higher ones together are one more.
  static constexpr std::size_t kTold = 32;

  ExactSum in;
  ExactSum direct;                               // out below without having been scattered
  std::array<ExactSum, kTold + 1> above, below;  // out, by order - 1
  ExactSum absorbed;                             // by crystals
  ExactSum leftOut;                              // would have been scattered more often than is followed
  ExactSum cutOff;                               // of walks that were given up
  ExactSum drawn;  // lost by where walks were led to rather than elsewhere (FlightPlaces): none on average

  static std::size_t placeOf(int order) { return order <= int{kTold} ? static_cast<std::size_t>(order) - 1 : kTold; }

  void merge(const OrderLedger& other);

  /// Of a whole run: shares out what was drawn among all that was scattered.
  void shareOutDrawn();

  /// Shares of `in` of all orders together.
  double reflected() const;
  double transmitted() const;  // the direct light included

  /// in less all the rest, as a share of in.
  double imbalance() const;
};

}  // namespace parhelion
