// SPDX-License-Identifier: Apache-2.0
#include "sky/distortion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace parhelion {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The root of a function that changes its sign between `lo` and `hi`, to the last bit.
template <class F>
double bisected(F f, double lo, double hi) {
  const bool rising = f(lo) < 0.0;
  for (double middle = 0.5 * (lo + hi); middle > lo && middle < hi; middle = 0.5 * (lo + hi)) {
    ((f(middle) < 0.0) == rising ? lo : hi) = middle;
  }
  return hi;
}

}  // namespace

double Distortion::foldRadius() const {
  // The derivative, as a polynomial in u = r^2, falls to zero first where it does so between two of its own extrema.
  const auto slope = [this](double u) { return 1.0 + u * (3.0 * k1 + u * (5.0 * k2 + u * 7.0 * k3)); };
  const double a = 21.0 * k3, b = 5.0 * k2, c = 3.0 * k1;  // slope' = a u^2 + 2 b u + c
  std::array extrema{kInfinity, kInfinity};
  if (a == 0.0) {
    if (b != 0.0) extrema[0] = -0.5 * c / b;
  } else if (const double discriminant = b * b - a * c; discriminant > 0.0) {
    const double q = -(b + std::copysign(std::sqrt(discriminant), b));
    extrema[0] = q / a;
    if (q != 0.0) extrema[1] = c / q;
  }
  std::sort(extrema.begin(), extrema.end());
  constexpr double kFarthest = 1e12;  // beyond any picture
  double from = 0.0;
  for (double to : {extrema[0], extrema[1], kFarthest}) {
    if (!(to > from && to <= kFarthest)) continue;
    if (slope(to) <= 0.0) return std::sqrt(bisected(slope, from, to));
    from = to;
  }
  return kInfinity;
}

double Distortion::undistorted(double radius, double limit) const {
  if (none() || radius == 0.0) return radius;
  double lo = 0.0, hi = std::min(limit, radius);
  while (hi < limit && distorted(hi) < radius) hi = std::min(limit, 2.0 * hi);
  // Newton's steps, halving the interval instead where they leave it.
  double r = std::min(radius, hi);
  constexpr int kMostSteps = 60;
  for (int step = 0; step < kMostSteps; ++step) {
    constexpr double kRounding = 2.0 * std::numeric_limits<double>::epsilon();
    const double error = distorted(r) - radius;
    if (std::abs(error) <= kRounding * radius) return r;
    (error > 0.0 ? hi : lo) = r;
    const double u = r * r, slope = 1.0 + u * (3.0 * k1 + u * (5.0 * k2 + u * 7.0 * k3));
    const double newton = r - error / slope;
    r = newton > lo && newton < hi ? newton : 0.5 * (lo + hi);
  }
  return r;
}

}  // namespace parhelion
