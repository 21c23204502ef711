// SPDX-License-Identifier: Apache-2.0
#include "air/sun_masses.h"

#include <algorithm>
#include <cmath>

#include "parallel/loops.h"

namespace parhelion {

namespace {

// The table's nodes lie more densely near the ground and near the horizon, by squares. So many keep transmittances at
// the horizon to two hundredths and all others to two thousandths of themselves.
constexpr int kAltitudes = 128, kElevations = 160;

struct TablePlace {
  std::size_t index;
  double t;
};

TablePlace placeIn(double share, int nodes) {
  const double x = std::clamp(share, 0.0, 1.0) * (nodes - 1);
  const int index = std::min(static_cast<int>(x), nodes - 2);
  return {static_cast<std::size_t>(index), x - index};
}

OfAir mix(const OfAir& a, const OfAir& b, double t) {
  return {a.rayleigh + t * (b.rayleigh - a.rayleigh), a.ozone + t * (b.ozone - a.ozone),
          a.aerosol + t * (b.aerosol - a.aerosol)};
}

}  // namespace

SunPlace::SunPlace(double altitudeHere, double sunSine) : altitude(altitudeHere), sine(sunSine) {
  const double horizon = horizonSine(kGroundRadius + std::max(0.0, altitude));
  // Near the horizon, where alone it matters, the sine of an angle is steeper than the angle by its cosine.
  share = shareAboveHorizon((sine - horizon) / std::sqrt(1.0 - horizon * horizon));
  aboveHorizon = std::sqrt(std::clamp((sine - horizon) / (1.0 - horizon), 0.0, 1.0));
}

SunMasses::SunMasses(const Atmosphere& air) : table_(static_cast<std::size_t>(kAltitudes * kElevations)) {
  forRows(kAltitudes, [&](int i) {
    const double w = double(i) / (kAltitudes - 1), radius = kGroundRadius + kAirTop * w * w;
    const double horizon = horizonSine(radius);
    for (int j = 0; j < kElevations; ++j) {
      const double v = double(j) / (kElevations - 1);
      table_[static_cast<std::size_t>(i * kElevations + j)] =
          air.massesToSpace({radius, std::min(1.0, horizon + (1.0 - horizon) * v * v)});
    }
  });
}

OfAir SunMasses::at(const SunPlace& place) const {
  const TablePlace row = placeIn(std::sqrt(std::max(0.0, place.altitude) / kAirTop), kAltitudes);
  const TablePlace column = placeIn(place.aboveHorizon, kElevations);
  const OfAir* low = &table_[row.index * kElevations + column.index];
  const OfAir* high = low + kElevations;
  return mix(mix(low[0], low[1], column.t), mix(high[0], high[1], column.t), row.t);
}

}  // namespace parhelion
