// SPDX-License-Identifier: Apache-2.0
#include "trace/bundle_bins.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace parhelion {

void BundleBins::add(const BundleDeposits<double>& bundle) {
  for (const auto& [bin, light] : bundle.all()) {
    addFixed(sums_[bin], toFixed(light));
    squares_[bin].addUnits(toFixed(light * light, kSquareScale));
  }
}

void BundleBins::merge(const BundleBins& other) {
  for (int i = 0; i < size(); ++i) {
    std::int64_t sum = sums_[i];
    addFixed(sum, other.sums_[i]);
    SquareTotal(squares_[i]).merge(other.squares_[i]);
  }
  for (int i = 0; i < size(); ++i) {
    sums_[i] += other.sums_[i];
    squares_[i].merge(other.squares_[i]);
  }
}

double BundleBins::fullness() const {
  return static_cast<double>(*std::ranges::max_element(sums_)) / 0x1p63;
}

void BundleBins::subtract(const BundleBins& other) {
  for (int i = 0; i < size(); ++i)
    if (other.sums_[i] > sums_[i] || other.squares_[i].units() > squares_[i].units())
      throw std::overflow_error("more light is taken out of a bin than is in it");
  for (int i = 0; i < size(); ++i) {
    sums_[i] -= other.sums_[i];
    squares_[i].subtract(other.squares_[i]);
  }
}

double BundleBins::error(int bin, std::uint64_t bundles) const {
  const double sum = light(bin), squares = squares_[bin].value();
  return bundles > 0 ? std::sqrt(std::max(0.0, squares - sum * sum / static_cast<double>(bundles))) : 0.0;
}

double BundleBins::shareError(int bin, std::uint64_t bundles, double all) const {
  if (bundles == 0) return 0.0;
  constexpr double kRuleOfThree = 3.0;
  if (sums_[bin] == 0) return std::min(1.0, kRuleOfThree / static_cast<double>(bundles));
  return error(bin, bundles) / all;
}

void BundleBins::visitSums(SumVisitor& visitor) {
  visitor.visit(std::span(sums_));
  for (SquareTotal& square : squares_) visitor.visit(square);
}

}  // namespace parhelion
