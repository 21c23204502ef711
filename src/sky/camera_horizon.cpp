// SPDX-License-Identifier: Apache-2.0
#include "sky/camera.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "math/portable.h"
#include "sky/edge_integral.h"

// The solid angle of what lies above the horizon is the integral of sin(elevation) d(azimuth) around its border
// (Stokes). On the horizon itself that is 0, so the border of the pixel is all that counts, where it is above. Lengths
// are in focal lengths.

namespace parhelion {
namespace {

constexpr double kNothing = 1e-9;      // of a cell: below the error of what is above the horizon
constexpr double kLargestCell = 0.08;  // rad; of these, one that the horizon crosses keeps far from the zenith
constexpr int kDeepest = 10;           // halvings, down to cells of a thousandth of a pixel's side
constexpr double kDifference = 0.05;   // of a cell's side, or rad: step of the derivatives
constexpr int kIntervals = 8;          // in each of which a border crosses the horizon once at most
constexpr int kHalvings = 40;          // of an interval, to find where

/// Derivative at t of a line over [from, to], smooth there but perhaps not beyond: of the polynomial through five of
/// its points, `step` apart or closer.
template <class Line>
Vec3 slopeOf(const Line& line, double t, double from, double to, double step) {
  const double h = std::min(step, 0.2 * (to - from));
  const double middle = std::clamp(t, from + 2.0 * h, to - 2.0 * h), u = (t - middle) / h;
  const double u2 = u * u, u3 = 4.0 * u * u2;
  const std::array weights = {(u3 - 6.0 * u2 - 2.0 * u + 2.0) / 24.0, -(u3 - 3.0 * u2 - 8.0 * u + 4.0) / 6.0,
                              (u3 - 10.0 * u) / 4.0, -(u3 + 3.0 * u2 - 8.0 * u - 4.0) / 6.0,
                              (u3 + 6.0 * u2 - 2.0 * u - 2.0) / 24.0};
  Vec3 sum(0.0);
  for (std::size_t k = 0; k < weights.size(); ++k)
    sum += weights[k] * line(middle + (static_cast<double>(k) - 2.0) * h);
  return sum / h;
}

/// Integral of sin(elevation) d(azimuth) over the parts of a line that are above the horizon. `line` leads from a
/// number in [from, to] to a direction.
template <class Line>
double integralAbove(const Line& line, double from, double to, double step) {
  const auto height = [&](double t) { return line(t).z; };
  const auto integrand = [&](double t) {
    const Vec3 v = line(t);
    const Vec3 slope = slopeOf(line, t, from, to, step);
    const double squared = v.x * v.x + v.y * v.y;
    return squared > 0.0 ? v.z * (v.x * slope.y - v.y * slope.x) / squared : 0.0;
  };
  const auto piece = [&](double a, double b) {
    return b > a && height(0.5 * (a + b)) > 0.0 ? integrate(integrand, a, b - a) : 0.0;
  };
  if (!(from < to)) return 0.0;
  double sum = 0.0, begun = from;
  for (int i = 0; i < kIntervals; ++i) {
    double lo = from + (to - from) * i / kIntervals, hi = from + (to - from) * (i + 1) / kIntervals;
    const bool isAbove = height(lo) > 0.0;
    if (isAbove == (height(hi) > 0.0)) continue;
    for (int k = 0; k < kHalvings; ++k) {
      const double middle = 0.5 * (lo + hi);
      ((height(middle) > 0.0) == isAbove ? lo : hi) = middle;
    }
    sum += piece(begun, lo);
    begun = lo;
  }
  return sum + piece(begun, to);
}

/// The angles at which a circle of this radius about the origin meets the lines of a rectangle's sides, ascending, from
/// 0 to 2 pi.
std::vector<double> crossings(double radius, const Vec2& lo, const Vec2& hi) {
  std::vector<double> angles{0.0, 2.0 * kPi};
  const auto add = [&](double x, double y) {
    const double angle = portable::atan2(y, x);
    angles.push_back(angle < 0.0 ? angle + 2.0 * kPi : angle);
  };
  for (const Vec2& corner : {lo, hi}) {
    const Vec2 other{std::sqrt(std::max(0.0, (radius - corner.x) * (radius + corner.x))),
                     std::sqrt(std::max(0.0, (radius - corner.y) * (radius + corner.y)))};
    for (const double side : {-1.0, 1.0}) {
      if (std::abs(corner.x) < radius) add(corner.x, side * other.x);
      if (std::abs(corner.y) < radius) add(side * other.y, corner.y);
    }
  }
  std::sort(angles.begin(), angles.end());
  return angles;
}

}  // namespace

double Camera::borderAbove(Vec2 lo, Vec2 hi, bool isBack) const {
  // An edge at distance c from the axis is (c, q sin t): smooth up to the rim, also where the picture is not.
  const auto edge = [&](double c, double from, double to, bool isVertical) {
    const bool hasRim = std::isfinite(circleRadius_);
    if (hasRim && std::abs(c) >= circleRadius_) return 0.0;
    const double q = std::sqrt((circleRadius_ - c) * (circleRadius_ + c));
    const auto parameter = [&](double s) {
      if (!hasRim) return s;
      s = std::clamp(s, -q, q);
      return portable::atan2(s, std::sqrt((q - s) * (q + s)));
    };
    const auto line = [&](double t) {
      const double s = hasRim ? q * portable::sin(t) : t;
      return directionWithin(isVertical ? Vec2(c, s) : Vec2(s, c), isBack);
    };
    const double step = kDifference * (hasRim ? std::min(1.0, (to - from) / q) : to - from);
    return integralAbove(line, parameter(from), parameter(to), step);
  };
  double sum = edge(lo.y, lo.x, hi.x, false) - edge(hi.y, lo.x, hi.x, false);
  sum += edge(hi.x, lo.y, hi.y, true) - edge(lo.x, lo.y, hi.y, true);
  const Vec2 far = glm::max(glm::abs(lo), glm::abs(hi));
  if (!(glm::length(far) > circleRadius_)) return sum;

  const std::vector<double> angles = crossings(circleRadius_, lo, hi);
  const auto rim = [&](double t) {
    const auto [sine, cosine] = portable::sincos(t);
    return Vec2(circleRadius_ * cosine, circleRadius_ * sine);
  };
  for (std::size_t i = 1; i < angles.size(); ++i) {
    const Vec2 middle = rim(0.5 * (angles[i - 1] + angles[i]));
    const bool inside = middle.x > lo.x && middle.x < hi.x && middle.y > lo.y && middle.y < hi.y;
    if (inside)
      sum += integralAbove([&](double t) { return directionWithin(rim(t), isBack); }, angles[i - 1], angles[i],
                           std::min(kDifference, (hi.x - lo.x) / circleRadius_));
  }
  return sum;
}

double Camera::solidAngleAbove(Vec2 lo, Vec2 hi, bool isBack, int depth) const {
  if (isPanorama(settings_.projection)) {
    lo = glm::max(lo, Vec2(-kPi, -0.5 * kPi));
    hi = glm::min(hi, Vec2(kPi, 0.5 * kPi));
    if (!(lo.x < hi.x && lo.y < hi.y)) return 0.0;
  }
  const Vec2 middle = 0.5 * (lo + hi);
  const Vec3 centre = directionWithin(middle, isBack);
  double reach = 0.0;
  for (const Vec2& corner : {lo, hi, Vec2(lo.x, hi.y), Vec2(hi.x, lo.y)})
    reach = std::max(reach, glm::length(directionWithin(corner, isBack) - centre));
  constexpr double kRoom = 1.3;  // edges bulge between corners
  if (centre.z > kRoom * reach) return solidAngleOf(lo, hi);
  if (centre.z < -kRoom * reach) return 0.0;
  if (reach <= kLargestCell || depth == kDeepest) {
    const double whole = solidAngleOf(lo, hi), above = std::min(whole, std::abs(borderAbove(lo, hi, isBack)));
    return above > kNothing * whole ? above : 0.0;
  }
  double sum = 0.0;
  for (const Vec2& from : {lo, Vec2(middle.x, lo.y), Vec2(lo.x, middle.y), middle})
    sum += solidAngleAbove(from, from + 0.5 * (hi - lo), isBack, depth + 1);
  return sum;
}

}  // namespace parhelion
