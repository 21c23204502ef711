// SPDX-License-Identifier: Apache-2.0
#include "sky/camera.h"

#include <algorithm>
#include <cmath>

#include "math/portable.h"
#include "sky/edge_integral.h"
#include "sky/projections.h"

// The solid angle of a pixel of an azimuthal projection is the integral of (1 - cos theta) d phi around its border
// (Stokes). With F(r^2) = (1 - cos theta) / r^2, which is smooth at the axis, and d phi = (x dy - y dx) / r^2, an edge
// at distance c from the axis contributes c * integral of F(c^2 + s^2) ds, and an arc of the image circle
// R^2 F(R^2) * its angle. Lengths are in focal lengths.

namespace parhelion {
namespace {

// Of the parts of a pixel's border and its area: a few hundred times what is lost in adding them.
constexpr double kRoundingOfTerms = 1e-13;

/// A projection that knows the solid angle of a rectangle in its undistorted picture.
template <class Facts>
concept KnowsRectangles = requires(Vec2 corner) {
  Facts::rectangle(corner, corner);
};

/// What an edge at distance c, s from a to b, clipped to the image circle, contributes to the contour integral and
/// to the angle about the axis.
struct EdgeSum {
  double integral = 0.0;
  double angle = 0.0;
};

template <class EdgeIntegral>
EdgeSum edgeSum(const EdgeIntegral& edgeIntegral, double radius, double c, double a, double b) {
  const double chord2 = (radius - c) * (radius + c);
  if (c == 0.0 || chord2 <= 0.0) return {};
  const double chord = std::sqrt(chord2);
  a = std::max(a, -chord);
  b = std::min(b, chord);
  if (a >= b) return {};
  return {c * edgeIntegral(c, a, b), portable::atan2(c * (b - a), c * c + a * b)};
}

/// Share of the directions about the axis that lead into an interval: the axis in it, on its border, or outside.
double axisShare(double lo, double hi) { return lo < 0.0 && hi > 0.0 ? 1.0 : (lo == 0.0 || hi == 0.0 ? 0.5 : 0.0); }

}  // namespace

template <class Facts>
double Camera::distortedHeight(Facts facts, double squared) const {
  if (squared == 0.0) return 0.5;
  const double r = std::sqrt(squared), ideal = settings_.distortion.undistorted(r, idealRadius_);
  const auto [cosine, sinePerRadius] = facts.atSquaredRadius(ideal * ideal);
  const double sinePerPlace = sinePerRadius * ideal / r;
  // 1 - cos theta = sin^2 theta / (1 + cos theta), without cancellation near the axis.
  return cosine < 0.0 ? (1.0 - cosine) / squared : sinePerPlace * sinePerPlace / (1.0 + cosine);
}

template <class Facts>
double Camera::azimuthalSolidAngle(Facts facts, Vec2 lo, Vec2 hi) const {
  const double radius = circleRadius_;
  const Vec2 far{std::max(std::abs(lo.x), std::abs(hi.x)), std::max(std::abs(lo.y), std::abs(hi.y))};
  const bool distorted = !settings_.distortion.none();
  const auto integral = [&](double c, double a, double b) {
    if constexpr (!KnowsRectangles<Facts>) {
      if (!distorted) return facts.edgeIntegral(c, a, b);
    }
    return integrate([&](double s) { return distortedHeight(facts, c * c + s * s); }, a, b - a);
  };

  // Counter-clockwise: the edges at hi count positive, those at lo negative.
  const EdgeSum top = edgeSum(integral, radius, hi.y, lo.x, hi.x);
  const EdgeSum bottom = edgeSum(integral, radius, lo.y, lo.x, hi.x);
  const EdgeSum right = edgeSum(integral, radius, hi.x, lo.y, hi.y);
  const EdgeSum left = edgeSum(integral, radius, lo.x, lo.y, hi.y);
  double sum = (top.integral - bottom.integral) + (right.integral - left.integral);

  // Where the circle cuts the pixel, its arcs take up the angle about the axis that the edges leave.
  if (far.x * far.x + far.y * far.y > radius * radius) {
    const double edges = (top.angle - bottom.angle) + (right.angle - left.angle);
    const double arcs = 2.0 * kPi * axisShare(lo.x, hi.x) * axisShare(lo.y, hi.y) - edges;
    sum += facts.circleHeight(idealRadius_ * idealRadius_) * arcs;
    // A pixel that the circle touches in a corner shows no sky, whatever rounding leaves.
    const double terms = std::abs(top.integral) + std::abs(bottom.integral) + std::abs(right.integral) +
                         std::abs(left.integral) + (hi.x - lo.x) * (hi.y - lo.y);
    if (sum < kRoundingOfTerms * terms) return 0.0;
  }
  return std::max(0.0, sum);
}

double Camera::solidAngle(int x, int y) const {
  if (cutsHorizon()) {
    const bool isBack = discStep_ > 0.0 && x >= discStep_;
    const Vec2 left{(x - (isBack ? discStep_ : 0.0) - centre_.x) / focal_, (centre_.y - (y + 1.0)) / focal_};
    return solidAngleAbove(left, left + 1.0 / focal_, isBack);
  }
  // Above and below the axis pixels are alike, so y may grow downward. Where the axis is the centre of the picture or
  // of its half, all four quarters are alike; take the first.
  const int discWidth = width() / discs(settings_.projection);
  x %= discWidth;
  const double column = hasAlikeQuarters() ? std::min(x, discWidth - 1 - x) : x;
  const double row = hasAlikeQuarters() ? std::min(y, height() - 1 - y) : y;
  const Vec2 corner{column, row};
  return solidAngleOf((corner - centre_) / focal_, (corner + 1.0 - centre_) / focal_);
}

double Camera::solidAngleOf(Vec2 lo, Vec2 hi) const {
  return visitProjection(settings_.projection, [&](auto facts) {
    if constexpr (!facts.isAzimuthal) {
      return facts.rectangle(lo, hi);
    } else {
      if constexpr (KnowsRectangles<decltype(facts)>) {
        if (settings_.distortion.none()) return facts.rectangle(lo, hi);
      }
      return azimuthalSolidAngle(facts, lo, hi);
    }
  });
}

std::vector<double> Camera::solidAngles() const {
  std::vector<double> all(static_cast<std::size_t>(width()) * height());
  const auto rowAt = [&](int y) { return all.begin() + static_cast<std::ptrdiff_t>(y) * width(); };
  const auto fill = [&](auto facts, int y, auto row) {
    if constexpr (facts.isPanorama) {
      if (!cutsHorizon()) {
        const auto latitudes = facts.latitudes((y - centre_.y) / focal_, (y + 1.0 - centre_.y) / focal_);
        for (int x = 0; x < ownColumns(); ++x)
          row[x] = facts.solidAngle(latitudes, (x - centre_.x) / focal_, (x + 1.0 - centre_.x) / focal_);
        return;
      }
    }
    for (int x = 0; x < ownColumns(); ++x) row[x] = solidAngle(x, y);
  };
  for (int y = 0; y < ownRows(); ++y) {
    const auto row = rowAt(y);
    visitProjection(settings_.projection, [&](auto facts) { fill(facts, y, row); });
    std::reverse_copy(row, row + (width() - ownColumns()), row + ownColumns());
  }
  for (int y = ownRows(); y < height(); ++y) std::copy_n(rowAt(height() - 1 - y), width(), rowAt(y));
  return all;
}

}  // namespace parhelion
