// SPDX-License-Identifier: Apache-2.0
#include "trace/order_ledger.h"

namespace parhelion {

namespace {

double sumOf(const std::array<ExactSum, OrderLedger::kTold + 1>& orders) {
  ExactSum sum;
  for (const ExactSum& one : orders) sum.merge(one);
  return sum.value();
}

}  // namespace

void OrderLedger::merge(const OrderLedger& other) {
  in.merge(other.in);
  direct.merge(other.direct);
  for (std::size_t k = 0; k <= kTold; ++k) {
    above[k].merge(other.above[k]);
    below[k].merge(other.below[k]);
  }
  leftOut.merge(other.leftOut);
  cutOff.merge(other.cutOff);
}

double OrderLedger::reflected() const { return in.value() > 0.0 ? sumOf(above) / in.value() : 0.0; }

double OrderLedger::transmitted() const {
  return in.value() > 0.0 ? (direct.value() + sumOf(below)) / in.value() : 0.0;
}

double OrderLedger::imbalance() const {
  const double all = in.value();
  return all > 0.0 ? (all - direct.value() - sumOf(above) - sumOf(below) - leftOut.value() - cutOff.value()) / all
                   : 0.0;
}

}  // namespace parhelion
