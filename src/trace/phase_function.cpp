// SPDX-License-Identifier: Apache-2.0
#include "trace/phase_function.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "math/conventions.h"
#include "math/portable.h"

namespace parhelion {

namespace {

// Steps of the angle, of 0.02 degrees: between two of them the function is taken as its mean.
constexpr std::size_t kSteps = 9000;
constexpr double kStep = kPi / static_cast<double>(kSteps);
// Below this g light goes everywhere alike, and the quantile's formula would divide by nothing.
constexpr double kIsotropic = 1e-6;

double cosineOf(std::size_t step) { return portable::cos(kStep * static_cast<double>(step)); }

}  // namespace

PhaseFunction::PhaseFunction(const PhaseSettings& settings) {
  if (const auto* table = std::get_if<PhaseTable>(&settings)) {
    tabulate(*table);
    return;
  }
  g_ = std::get<HenyeyGreenstein>(settings).g;
  if (!(std::abs(g_) < 1.0)) throw std::invalid_argument("g must lie between -1 and 1");
}

void PhaseFunction::tabulate(const PhaseTable& table) {
  const auto& [angles, values] = table;
  if (angles.size() < 2 || angles.size() != values.size() || !std::ranges::is_sorted(angles) || angles.front() != 0.0)
    throw std::invalid_argument("a phase function needs angles that grow from 0 to 180 degrees, and a value for each");
  for (std::size_t k = 0; k < kSteps; ++k) {
    const double angle = kStep * (static_cast<double>(k) + 0.5);
    const auto after = std::min<std::size_t>(
        std::max<std::ptrdiff_t>(std::ranges::upper_bound(angles, angle) - angles.begin(), 1), angles.size() - 1);
    const double width = angles[after] - angles[after - 1],
                 t = width > 0.0 ? std::min(1.0, (angle - angles[after - 1]) / width) : 1.0;
    value_.push_back(values[after - 1] + t * (values[after] - values[after - 1]));
  }
  below_.assign(1, 0.0);
  for (std::size_t k = 0; k < kSteps; ++k)
    below_.push_back(below_.back() + value_[k] * 2.0 * kPi * (cosineOf(k) - cosineOf(k + 1)));
  const double all = below_.back();
  if (!(all > 0.0) || !std::isfinite(all) || std::ranges::min(values) < 0.0)
    throw std::invalid_argument("the values of a phase function must not be negative, nor all 0");
  for (double& value : value_) value /= all;
  for (double& share : below_) share /= all;
}

double PhaseFunction::at(double cosine) const {
  if (value_.empty()) {
    const double square = 1.0 + g_ * g_ - 2.0 * g_ * cosine;
    return (1.0 - g_ * g_) / (4.0 * kPi * square * std::sqrt(square));
  }
  const double angle = portable::atan2(std::sqrt(std::max(0.0, 1.0 - cosine * cosine)), cosine);
  return value_[std::min(static_cast<std::size_t>(angle / kStep), kSteps - 1)];
}

double PhaseFunction::cosineAt(double u) const {
  if (value_.empty()) {
    if (std::abs(g_) < kIsotropic) return 2.0 * u - 1.0;
    // Witt 1977, eq. 15.
    const double term = (1.0 - g_ * g_) / (1.0 - g_ + 2.0 * g_ * u);
    return std::clamp((1.0 + g_ * g_ - term * term) / (2.0 * g_), -1.0, 1.0);
  }
  const auto after = std::ranges::upper_bound(below_, u) - below_.begin();
  const auto step = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(after - 1, 0, kSteps - 1));
  const double width = below_[step + 1] - below_[step], t = width > 0.0 ? (u - below_[step]) / width : 0.5;
  return cosineOf(step) + std::min(1.0, t) * (cosineOf(step + 1) - cosineOf(step));
}

}  // namespace parhelion
