// SPDX-License-Identifier: Apache-2.0
#pragma once

// What the statistical tests share. Seeds are fixed, so a test passes or fails for good; the bound of 4.5 sigma
// (probability 7e-6 two-sided) says how surprising a failure would be if the code were right.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace parhelion {

/// The bound for a single statistic.
inline constexpr double kSigmas = 4.5;

/// How many standard deviations the chi-square of `observed` against `expected` counts lies above its mean, for counts
/// of a fixed total. Neighbouring cells are pooled until 20 are expected. Wilson & Hilferty's normal approximation.
inline double chiSquareSigma(const std::vector<double>& observed, const std::vector<double>& expected) {
  if (observed.size() != expected.size()) throw std::invalid_argument("counts of different length");
  constexpr double kPooled = 20.0;
  double chiSquare = 0.0, hits = 0.0, mean = 0.0, left = 0.0;
  for (const double e : expected) left += e;
  int cells = 0;
  for (std::size_t i = 0; i < observed.size(); ++i) {
    hits += observed[i];
    mean += expected[i];
    left -= expected[i];
    // The last pool takes whatever is too little for one of its own.
    if (i + 1 < observed.size() && (mean < kPooled || left < kPooled)) continue;
    chiSquare += (hits - mean) * (hits - mean) / mean;
    ++cells;
    hits = mean = 0.0;
  }
  if (cells < 2) throw std::invalid_argument("too few counts for a chi-square test");
  const double variance = 2.0 / (9.0 * (cells - 1));
  return (std::cbrt(chiSquare / (cells - 1)) - (1.0 - variance)) / std::sqrt(variance);
}

/// The same for `samples` of a variable whose cumulative distribution on [lo, hi] is `cumulative`, in equal bins. A
/// sample outside the range counts as infinitely surprising.
inline double chiSquareSigma(const std::vector<double>& samples, const std::function<double(double)>& cumulative,
                             double lo, double hi, int bins) {
  std::vector<double> observed(bins, 0.0), expected(bins);
  for (const double x : samples) {
    if (!(x >= lo && x <= hi)) return HUGE_VAL;
    ++observed[std::min(bins - 1, static_cast<int>((x - lo) / (hi - lo) * bins))];
  }
  for (int i = 0; i < bins; ++i)
    expected[i] = static_cast<double>(samples.size()) *
                  (cumulative(lo + (hi - lo) * (i + 1) / bins) - cumulative(lo + (hi - lo) * i / bins));
  return chiSquareSigma(observed, expected);
}

/// The cumulative distribution of an unnormalised density on [lo, hi], by the midpoint rule at equal steps.
inline std::function<double(double)> cumulativeOf(const std::function<double(double)>& density, double lo, double hi) {
  constexpr int kSteps = 100000;
  std::vector<double> sums(1, 0.0);
  for (int i = 0; i < kSteps; ++i) sums.push_back(sums.back() + density(lo + (hi - lo) * (i + 0.5) / kSteps));
  return [=, sums = std::move(sums)](double x) {
    const double at = std::clamp((x - lo) / (hi - lo), 0.0, 1.0) * kSteps;
    const int i = std::min(static_cast<int>(at), kSteps - 1);
    return (sums[i] + (at - i) * (sums[i + 1] - sums[i])) / sums.back();
  };
}

/// Mean and standard error of a sample, one value at a time (Welford).
class SampleMean {
 public:
  void add(double x) {
    const double step = x - mean_;
    mean_ += step / ++count_;
    squares_ += step * (x - mean_);
  }
  double mean() const { return mean_; }
  double variance() const { return squares_ / (count_ - 1.0); }
  double standardError() const { return std::sqrt(variance() / count_); }

  /// Standard errors between the mean and `truth`.
  double sigmasFrom(double truth) const { return std::abs(mean_ - truth) / standardError(); }

 private:
  double count_ = 0.0, mean_ = 0.0, squares_ = 0.0;
};

}  // namespace parhelion
