// SPDX-License-Identifier: Apache-2.0
#include "trace/energy_ledger.h"

namespace parhelion {

void EnergyLedger::merge(const EnergyLedger& other) {
  in.merge(other.in);
  out.merge(other.out);
  filtered.merge(other.filtered);
  absorbed.merge(other.absorbed);
  cutOff.merge(other.cutOff);
  lost.merge(other.lost);
}

double EnergyLedger::imbalance() const {
  const double all = in.value();
  return all > 0.0 ? (all - out.value() - filtered.value() - absorbed.value() - cutOff.value() - lost.value()) / all
                   : 0.0;
}

}  // namespace parhelion
