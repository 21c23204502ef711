// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <vector>

#include "sky/fixed_point.h"

namespace parhelion {

/// What one bundle of rays brings to numbered places of layers. Light that falls into the same place of the same layer
/// more than once is one deposit, because errors are measured by the scatter between bundles.
class LayeredDeposits {
 public:
  struct Deposit {
    int place, layer;
    FixedLight light;
  };

  void clear() { deposits_.clear(); }
  void add(int place, int layer, const FixedLight& light) {
    for (Deposit& d : deposits_)
      if (d.place == place && d.layer == layer) {
        d.light += light;
        return;
      }
    deposits_.push_back({place, layer, light});
  }
  const std::vector<Deposit>& all() const { return deposits_; }

  /// Calls take(place, squares, hits) for each place that has deposits of several layers: what SkyTally::Shared holds.
  template <class Take>
  void forShared(const Take& take) const {
    const auto isOther = [this](const Deposit& d) { return d.layer != deposits_.front().layer; };
    if (std::none_of(deposits_.begin(), deposits_.end(), isOther)) return;
    for (std::size_t i = 0; i < deposits_.size(); ++i) {
      FixedLight whole = deposits_[i].light;
      std::int64_t apart = whole.squared(), more = 0;
      bool isFirst = true;
      for (std::size_t k = 0; k < deposits_.size(); ++k) {
        if (k == i || deposits_[k].place != deposits_[i].place) continue;
        if (k < i) {
          isFirst = false;
          break;
        }
        whole += deposits_[k].light;
        apart += deposits_[k].light.squared();
        ++more;
      }
      if (isFirst && more > 0) take(deposits_[i].place, whole.squared() - apart, more);
    }
  }

 private:
  std::vector<Deposit> deposits_;
};

}  // namespace parhelion
