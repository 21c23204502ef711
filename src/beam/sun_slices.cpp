// SPDX-License-Identifier: Apache-2.0
#include "beam/sun_slices.h"

#include <algorithm>
#include <cmath>

#include "math/portable.h"

namespace parhelion {

namespace {

// The disc ends within its radius in spite of rounding.
constexpr double kInside = 1.0 - 1e-9;

/// A horizontal cut through the disc.
struct Cut {
  double sin, cos;     // of its elevation
  double halfAzimuth;  // half its extent, rad
  double width;        // solid angle that it stands for, more or less
};

}  // namespace

SunSlices::SunSlices(const SunFace& sun, int cells, int lines) {
  const double elevation = portable::atan2(sun.toCentre.z, std::hypot(sun.toCentre.x, sun.toCentre.y)),
               azimuth = portable::atan2(sun.toCentre.y, sun.toCentre.x);
  if (!(sun.radius > 0.0)) {
    elevations_ = {elevation};
    lines_ = {{{{azimuth, 1.0}}, 1.0, 1.0}};
    return;
  }
  // Elevations and shares are sines of even steps: at both ends cuts and lines come to nothing, and so smoothly that
  // the trapezoidal rule is as good as exact. Beyond a pole there are no elevations.
  const double low = std::max(elevation - sun.radius, -0.5 * kPi), high = std::min(elevation + sun.radius, 0.5 * kPi);
  const auto [sinCentre, cosCentre] = portable::sincos(elevation);
  std::vector<Cut> cuts;
  for (int k = 0; k <= cells; ++k) {
    const auto [sine, cosine] = portable::sincos(kPi * (static_cast<double>(k) / cells - 0.5));
    elevations_.push_back(0.5 * (low + high) + 0.5 * (high - low) * sine);
    const auto [sin, cos] = portable::sincos(elevations_.back());
    const double over = portable::cos(sun.radius) - sin * sinCentre, by = cos * cosCentre;
    // A circle about a pole may lie within the disc.
    const double half = over >= by ? 0.0 : over <= -by ? kPi : std::acos(over / by);
    cuts.push_back({sin, cos, half, half * cos * cosine});
  }
  double all = 0.0, second = 0.0;
  for (int k = 1; k < lines; ++k) {
    const auto [share, cosine] = portable::sincos(kPi * (static_cast<double>(k) / lines - 0.5));
    Line line{{}, 0.0, 0.0};
    double sum = 0.0;
    for (const Cut& cut : cuts) {
      const double besides = share * cut.halfAzimuth;
      const double onto = cut.sin * sinCentre + cut.cos * cosCentre * portable::cos(besides);
      const double off = std::min(std::acos(std::min(onto, 1.0)), kInside * sun.radius);
      line.points.push_back({azimuth + besides, cut.width * sun.brightness(off)});
      sum += line.points.back().weight;
    }
    // The first and the last of them are 0.
    for (Point& point : line.points) point.weight *= cells / sum;
    line.share = cosine * sum;
    if (k % 2 == 0) line.coarse = line.share;
    all += line.share;
    second += line.coarse;
    lines_.push_back(line);
  }
  for (Line& line : lines_) {
    line.share /= all;
    line.coarse /= second;
  }
}

}  // namespace parhelion
