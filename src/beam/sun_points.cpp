// SPDX-License-Identifier: Apache-2.0
#include "beam/sun_points.h"

#include <cmath>

#include <glm/geometric.hpp>

#include "beam/sun_frame.h"
#include "math/gauss_legendre.h"
#include "math/portable.h"

namespace parhelion {

namespace {

// Points of suns higher than this (radii of the disc from the zenith) do not go by rows.
constexpr double kNearZenith = 6.0;

}  // namespace

std::vector<SunRow> sunRows(const SunFace& sun, int count) {
  if (!(sun.radius > 0.0)) return {{sun.toCentre, {{0.0, 1.0}}}};
  const SunFrame frame(sun.toCentre);
  const double fromZenith = portable::atan2(std::hypot(sun.toCentre.x, sun.toCentre.y), sun.toCentre.z);
  const bool byRows = std::min(fromZenith, kPi - fromZenith) > kNearZenith * sun.radius;
  std::vector<SunRow> rows;
  double all = 0.0;
  for (int k = 1; k <= count; ++k) {
    // Chords of a disc are long by the root of 1 - y^2: Gauss's quadrature by Chebyshev's polynomials of the second
    // kind.
    const auto [sine, y] = portable::sincos(kPi * k / (count + 1));
    SunRow row;
    for (const auto& [x, part] : gaussLegendre(count)) {
      const double across = x * sine * sun.radius, up = y * sun.radius, off = std::hypot(across, up);
      const double weight = sine * sine * part * sun.brightness(std::min(off, sun.radius * (1.0 - 1e-9)));
      all += weight;
      const auto toward = [&](double besides) {
        return glm::normalize(sun.toCentre + std::tan(up) * frame.up + std::tan(besides) * frame.left);
      };
      if (!byRows) {
        rows.push_back({toward(across), {{0.0, weight}}});
        continue;
      }
      row.toSun = toward(0.0);
      row.points.push_back({across / std::hypot(row.toSun.x, row.toSun.y), weight});
    }
    if (byRows) rows.push_back(row);
  }
  for (SunRow& row : rows)
    for (SunRow::Point& point : row.points) point.weight /= all;
  return rows;
}

}  // namespace parhelion
