// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "math/exact_sum.h"
#include "trace/bundle_bins.h"
#include "trace/film.h"

namespace parhelion {

/// The totals of a map or a profile by their names in files: counts as such, light in units of ExactSum.
using NamedTotals = std::map<std::string, ExactSum::Units>;

/// What maps and profiles have in common: light in numbered bins, and totals of the whole run.
class MeasuringFilm : public Film {
 public:
  void merge(Film& fromThread) override;
  void visitSums(SumVisitor& visitor) override;
  double fullness() const override { return bins_.fullness(); }

  /// All that it has summed, for files and for adding films of different rays. setTotals() takes what totals() gives:
  /// throws std::out_of_range where one is missing.
  NamedTotals totals() const;
  void setTotals(const NamedTotals& totals);
  const BundleBins& sums() const { return bins_; }
  BundleBins& sums() { return bins_; }

 protected:
  /// The total of intercepted light, which all have, is the first. The names of all must outlive the film.
  static constexpr std::size_t kIntercepted = 0;
  static constexpr const char* kInterceptedName = "intercepted";
  MeasuringFilm(int bins, std::span<const std::string> names) : bins_(bins), names_(names), totals_(names.size()) {}

  ExactSum& total(std::size_t index) { return totals_[index]; }
  double valueOf(std::size_t index) const { return totals_[index].value(); }
  std::uint64_t rays() const { return rays_; }
  std::uint64_t bundles() const { return bundles_; }

  /// Adds a bundle of so many rays that brought this light.
  void addBundle(const BundleDeposits<double>& deposits, int rays);

 private:
  BundleBins bins_;
  std::span<const std::string> names_;
  std::vector<ExactSum> totals_;
  std::uint64_t rays_ = 0, bundles_ = 0;
};

}  // namespace parhelion
