// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <span>

#include "sky/camera.h"

#include "math/portable.h"

// The solid angle of a pixel of an azimuthal projection is the integral of (1 - cos theta) d phi around its border
// (Stokes). With F(r^2) = (1 - cos theta) / r^2, which is smooth at the axis, and d phi = (x dy - y dx) / r^2, an edge
// at distance c from the axis contributes c * integral of F(c^2 + s^2) ds, and an arc of the image circle
// R^2 F(R^2) * its angle. Lengths are in focal lengths.

namespace parhelion {
namespace {

struct Node {
  double x, weight;
};

// Gauss-Legendre on [-1, 1]: the nodes above 0, each stands for two.
constexpr Node kGauss4[] = {{0.33998104358485626, 0.65214515486254609}, {0.86113631159405257, 0.34785484513745385}};
constexpr Node kGauss16[] = {
    {0.095012509837637441, 0.1894506104550685}, {0.28160355077925892, 0.18260341504492358},
    {0.45801677765722737, 0.16915651939500254}, {0.61787624440264377, 0.14959598881657674},
    {0.755404408355003, 0.12462897125553388},   {0.86563120238783176, 0.095158511682492786},
    {0.9445750230732326, 0.062253523938647894}, {0.98940093499164994, 0.027152459411754096},
};

// Up to this length (rad) four nodes do: the integrands are analytic within 1.5 rad, so their error is below 1e-14.
constexpr double kShortEdge = 0.1;

template <typename Function>
double integrate(Function f, double from, double length) {
  const double half = 0.5 * length, middle = from + half;
  double sum = 0.0;
  for (const Node& n : length < kShortEdge ? std::span<const Node>(kGauss4) : std::span<const Node>(kGauss16)) {
    sum += n.weight * (f(middle - half * n.x) + f(middle + half * n.x));
  }
  return sum * half;
}

/// Integral of F over s in [a, b] for the equidistant projection, F = (1 - cos r) / r^2.
double equidistantEdge(double c, double a, double b) {
  const auto f = [c](double s) {
    const double halfAngle = 0.5 * std::sqrt(c * c + s * s);
    if (halfAngle == 0.0) return 0.5;
    const double sinc = portable::sin(halfAngle) / halfAngle;
    return 0.5 * sinc * sinc;
  };
  return integrate(f, a, b - a);
}

/// The same for the orthographic projection, F = 1 / (1 + sqrt(1 - r^2)). With s = q sin t, q^2 = 1 - c^2, the
/// integrand q cos t / (1 + q cos t) is smooth up to the rim, where F itself is not.
double orthographicEdge(double c, double a, double b) {
  const double q2 = (1.0 - c) * (1.0 + c), q = std::sqrt(q2);
  const auto cosine = [=](double s) { return std::sqrt(std::max(0.0, (q - s) * (q + s))); };
  const double wa = cosine(a), wb = cosine(b);
  // q^2 sin(tb - ta) = b wa - a wb, which cancels where a and b are on the same side.
  const double sum = b * wa + a * wb;
  const double sine = a * b > 0.0 ? q2 * (b - a) * (b + a) / sum : b * wa - a * wb;
  const auto f = [q](double t) {
    const double w = q * portable::cos(t);
    return w / (1.0 + w);
  };
  return integrate(f, portable::atan2(a, wa), portable::atan2(sine, wa * wb + a * b));
}

double edgeIntegral(Projection projection, double c, double a, double b) {
  switch (projection) {
    case Projection::fisheyeEquidistant:
      return equidistantEdge(c, a, b);
    case Projection::fisheyeOrthographic:
      return orthographicEdge(c, a, b);
    case Projection::fisheyeStereographic: {
      const double q2 = 4.0 + c * c, q = std::sqrt(q2);  // F = 2 / (4 + r^2)
      return 2.0 / q * portable::atan2((b - a) * q, q2 + a * b);
    }
    case Projection::fisheyeEqualArea:
    case Projection::rectilinear:
    case Projection::equirectangular:
      break;
  }
  return 0.5 * (b - a);  // equal area: F = 1/2
}

/// R^2 F(R^2) = 1 - cos theta at the image circle.
double circleHeight(Projection projection, double r2) {
  switch (projection) {
    case Projection::fisheyeEquidistant: {
      const double sine = portable::sin(0.5 * std::sqrt(r2));
      return 2.0 * sine * sine;
    }
    case Projection::fisheyeOrthographic:
      return r2 / (1.0 + std::sqrt(std::max(0.0, 1.0 - r2)));
    case Projection::fisheyeStereographic:
      return 2.0 * r2 / (4.0 + r2);
    case Projection::rectilinear:  // has a circle only where its distortion folds
      return r2 / (1.0 + r2 + std::sqrt(1.0 + r2));
    case Projection::fisheyeEqualArea:
    case Projection::equirectangular:
      break;
  }
  return 0.5 * r2;
}

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

/// Solid angle of a rectangle in the rectilinear picture, as two triangles (Van Oosterom & Strackee 1983). The
/// triangles' determinant is the rectangle's area, so nothing cancels in small pixels.
double rectilinearSolidAngle(Vec2 lo, Vec2 hi) {
  const double area = (hi.x - lo.x) * (hi.y - lo.y);
  const auto triangle = [area](Vec3 a, Vec3 b, Vec3 c) {
    const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
    const double scale = la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb;
    return 2.0 * portable::atan2(area, scale);
  };
  const Vec3 a{lo.x, lo.y, 1.0}, c{hi.x, hi.y, 1.0};
  return triangle(a, {hi.x, lo.y, 1.0}, c) + triangle(a, c, {lo.x, hi.y, 1.0});
}

double equirectangularSolidAngle(Vec2 lo, Vec2 hi) {
  const double longitudes = std::min(hi.x, kPi) - std::max(lo.x, -kPi);
  const double south = std::max(lo.y, -0.5 * kPi), north = std::min(hi.y, 0.5 * kPi);
  if (longitudes <= 0.0 || north <= south) return 0.0;
  // sin(north) - sin(south) without cancellation
  return longitudes * 2.0 * portable::cos(0.5 * (north + south)) * portable::sin(0.5 * (north - south));
}

}  // namespace

double Camera::distortedHeight(double squared) const {
  if (squared == 0.0) return 0.5;
  const double r = std::sqrt(squared), ideal = settings_.distortion.undistorted(r, idealRadius_);
  const auto [cosine, sinePerRadius] = atSquaredRadius(ideal * ideal);
  const double sinePerPlace = sinePerRadius * ideal / r;
  // 1 - cos theta = sin^2 theta / (1 + cos theta), without cancellation near the axis.
  return cosine < 0.0 ? (1.0 - cosine) / squared : sinePerPlace * sinePerPlace / (1.0 + cosine);
}

double Camera::azimuthalSolidAngle(Vec2 lo, Vec2 hi) const {
  const double radius = circleRadius_;
  const Vec2 far{std::max(std::abs(lo.x), std::abs(hi.x)), std::max(std::abs(lo.y), std::abs(hi.y))};
  const Projection projection = settings_.projection;
  const bool distorted = !settings_.distortion.none();
  const auto integral = [&](double c, double a, double b) {
    if (!distorted) return edgeIntegral(projection, c, a, b);
    return integrate([&](double s) { return distortedHeight(c * c + s * s); }, a, b - a);
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
    sum += circleHeight(projection, idealRadius_ * idealRadius_) * arcs;
  }
  return std::max(0.0, sum);
}

double Camera::solidAngle(int x, int y) const {
  // The axis is the picture's centre, so all four quarters are alike; take the first.
  const double column = std::min(x, width() - 1 - x), row = std::min(y, height() - 1 - y);
  const Vec2 lo = (Vec2{column, row} - centre_) / focal_;
  const Vec2 hi = (Vec2{column + 1.0, row + 1.0} - centre_) / focal_;
  if (settings_.projection == Projection::equirectangular) return equirectangularSolidAngle(lo, hi);
  if (settings_.projection == Projection::rectilinear && settings_.distortion.none())
    return rectilinearSolidAngle(lo, hi);
  return azimuthalSolidAngle(lo, hi);
}

std::vector<double> Camera::solidAngles() const {
  std::vector<double> all(static_cast<std::size_t>(width()) * height());
  for (int y = 0; y < height(); ++y) {
    for (int x = 0; x < width(); ++x) {
      const bool firstQuarter = 2 * x < width() && 2 * y < height();
      const std::size_t mirrored = static_cast<std::size_t>(std::min(y, height() - 1 - y)) * width() +
                                   static_cast<std::size_t>(std::min(x, width() - 1 - x));
      all[static_cast<std::size_t>(y) * width() + x] = firstQuarter ? solidAngle(x, y) : all[mirrored];
    }
  }
  return all;
}

}  // namespace parhelion
