// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "math/exact_sum.h"
#include "math/sum_visitor.h"
#include "sky/fixed_point.h"

namespace parhelion {

/// What one bundle of rays adds to numbered bins. If its light falls into a bin more than once, that light is summed to
/// one deposit, because errors are measured by the scatter between bundles.
template <class Light, class Bin = int>
class BundleDeposits {
 public:
  struct Deposit {
    Bin bin;
    Light light;
  };

  void clear() { deposits_.clear(); }
  void add(const Bin& bin, const Light& light) {
    for (Deposit& d : deposits_)
      if (d.bin == bin) {
        d.light += light;
        return;
      }
    deposits_.push_back({bin, light});
  }
  const std::vector<Deposit>& all() const { return deposits_; }

 private:
  std::vector<Deposit> deposits_;
};

/// For each of any number of bins, two exact sums over bundles: of the light that a bundle brought, and of its square.
/// One bin may hold all the light of a run, and squares have room for bundles of any size.
class BundleBins {
 public:
  explicit BundleBins(int bins) : sums_(bins), squares_(bins) {}

  int size() const { return static_cast<int>(sums_.size()); }
  void add(const BundleDeposits<double>& bundle);

  /// Adds as many other bins, or takes out again what was added. Where they throw std::overflow_error, nothing has
  /// changed.
  void merge(const BundleBins& other);
  void subtract(const BundleBins& other);
  void visitSums(SumVisitor& visitor);

  /// How full the fullest sum of light is, from 0 to 1. Squares have room for more than there ever is.
  double fullness() const;

  /// The numbers of a bin, for files: units of kWeightScale and of kSquareScale.
  std::int64_t sum(int bin) const { return sums_[bin]; }
  SquareTotal::Units squares(int bin) const { return squares_[bin].units(); }
  void set(int bin, std::int64_t sum, SquareTotal::Units squares) {
    sums_[bin] = sum;
    squares_[bin] = SquareTotal(squares);
  }

  /// The light in a bin, in the unit of the deposits.
  double light(int bin) const { return fromFixed(sums_[bin]); }

  /// The standard error of light(bin), where `bundles` bundles were traced in all.
  double error(int bin, std::uint64_t bundles) const;

  /// The same as a share of `all` light that the bundles brought. In a bin without light nothing has scattered, and 0
  /// would say that it is known to be dark: there it is 3 / `bundles`, by the rule of three. Of something that none of
  /// n bundles did, no more than 3 in n do it in the long run, at 95 % confidence; each brings a whole bundle's light
  /// at the most. 0 before the first bundle.
  double shareError(int bin, std::uint64_t bundles, double all) const;

 private:
  std::vector<std::int64_t> sums_;
  std::vector<SquareTotal> squares_;
};

}  // namespace parhelion
