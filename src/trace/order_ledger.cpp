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
  absorbed.merge(other.absorbed);
  leftOut.merge(other.leftOut);
  cutOff.merge(other.cutOff);
  drawn.merge(other.drawn);
}

void OrderLedger::shareOutDrawn() {
  const double scattered = sumOf(above) + sumOf(below) + absorbed.value() + leftOut.value();
  if (!(scattered > 0.0)) return;
  const double factor = 1.0 + drawn.value() / scattered;
  const auto scale = [factor](ExactSum& sum) {
    const double before = sum.value();
    sum = {};
    sum.add(factor * before);
  };
  for (std::size_t k = 0; k <= kTold; ++k) {
    scale(above[k]);
    scale(below[k]);
  }
  scale(absorbed);
  scale(leftOut);
  drawn = {};
}

double OrderLedger::reflected() const { return in.value() > 0.0 ? sumOf(above) / in.value() : 0.0; }

double OrderLedger::transmitted() const {
  return in.value() > 0.0 ? (direct.value() + sumOf(below)) / in.value() : 0.0;
}

double OrderLedger::imbalance() const {
  const double all = in.value();
  const double gone = absorbed.value() + leftOut.value() + cutOff.value() + drawn.value();
  return all > 0.0 ? (all - direct.value() - sumOf(above) - sumOf(below) - gone) / all : 0.0;
}

}  // namespace parhelion
