// SPDX-License-Identifier: Apache-2.0
#include "trace/measuring_film.h"

#include <utility>

namespace parhelion {

namespace {

constexpr const char *kRaysName = "rays", *kBundlesName = "bundles";

}  // namespace

void MeasuringFilm::addBundle(const BundleDeposits<double>& deposits, int rays) {
  bins_.add(deposits);
  rays_ += static_cast<std::uint64_t>(rays);
  ++bundles_;
}

void MeasuringFilm::merge(Film& fromThread) {
  auto& other = dynamic_cast<MeasuringFilm&>(fromThread);
  bins_.merge(std::exchange(other.bins_, BundleBins(bins_.size())));
  rays_ += std::exchange(other.rays_, 0);
  bundles_ += std::exchange(other.bundles_, 0);
  for (std::size_t i = 0; i < totals_.size(); ++i) totals_[i].merge(std::exchange(other.totals_[i], {}));
}

void MeasuringFilm::visitSums(SumVisitor& visitor) {
  bins_.visitSums(visitor);
  visitor.visit(rays_);
  visitor.visit(bundles_);
  for (ExactSum& total : totals_) visitor.visit(total);
}

NamedTotals MeasuringFilm::totals() const {
  NamedTotals totals{{kBundlesName, static_cast<ExactSum::Units>(bundles_)},
                     {kRaysName, static_cast<ExactSum::Units>(rays_)}};
  for (std::size_t i = 0; i < totals_.size(); ++i) totals[names_[i]] = totals_[i].units();
  return totals;
}

void MeasuringFilm::setTotals(const NamedTotals& totals) {
  rays_ = static_cast<std::uint64_t>(totals.at(kRaysName));
  bundles_ = static_cast<std::uint64_t>(totals.at(kBundlesName));
  for (std::size_t i = 0; i < totals_.size(); ++i) totals_[i] = ExactSum(totals.at(names_[i]));
}

}  // namespace parhelion
