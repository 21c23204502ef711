// SPDX-License-Identifier: Apache-2.0
#include "beam/azimuth_light.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "math/portable.h"
#include "parallel/loops.h"

namespace parhelion {

AzimuthLight::AzimuthLight(const TracedPrisms& prisms, const RotationColumns<double>& rest,
                           std::vector<double> elevations, double turn, int pieces, int first, int last)
    : prisms_(prisms),
      rest_(rest),
      elevations_(std::move(elevations)),
      turn_(turn),
      pieces_(pieces),
      first_(first),
      last_(last),
      lights_(elevations_.size() * static_cast<std::size_t>(last - first)) {
  forEach(lights_.size(), [&](std::size_t k) {
    lights_[k] = traced(elevations_[k % elevations_.size()], first_ + static_cast<int>(k / elevations_.size()));
  });
}

std::vector<double> AzimuthLight::partsOf(double index) const {
  const std::vector<double>& indices = prisms_.indices;
  std::vector<double> parts(indices.size(), 0.0);
  const auto above = static_cast<std::size_t>(std::ranges::upper_bound(indices, index) - indices.begin());
  const std::size_t next = std::min(above, indices.size() - 1), last = std::max<std::size_t>(above, 1) - 1;
  const double t = next > last ? (index - indices[last]) / (indices[next] - indices[last]) : 0.0;
  parts[last] += 1.0 - t;
  parts[next] += t;
  return parts;
}

Triple<double> AzimuthLight::lightDirAt(double elevation, double azimuth) const {
  // With the crystal's azimuth turned away.
  const auto [up, level] = portable::sincos(elevation);
  const auto [sin, cos] = portable::sincos(azimuth);
  const Triple<double> light{-level * cos, level * sin, -up};
  return {dot(rest_.x, light), dot(rest_.y, light), dot(rest_.z, light)};
}

LightRow AzimuthLight::traced(double elevation, int piece) const {
  const auto phiOf = [](const Triple<double>& light) { return portable::atan2(light.y, light.x); };
  std::vector<RowDirection> directions;
  for (int k = 0; k <= kPiece; ++k) {
    const double column = piece * kPiece + k;
    const Triple<double> light = lightDirAt(elevation, azimuthAt(column));
    directions.push_back({phiOf(light), portable::atan2(std::hypot(light.x, light.y), -light.z),
                          phiOf(lightDirAt(elevation, azimuthAt(column + 0.5))), (k % kPiece ? 1.0 : 0.5) / columns()});
  }
  return {prisms_, directions, kRoom};
}

std::vector<int> AzimuthLight::classesIn(int piece) const {
  return classesOf(
      std::span(lights_).subspan(static_cast<std::size_t>(piece - first_) * elevations_.size(), elevations_.size()));
}

double AzimuthLight::wantedShare() const {
  if (!prisms_.wanted) return 1.0;
  double met = 0.0, intercepted = 0.0;
  for (const LightRow& light : lights_) {
    met += light.met() / columns();
    intercepted += light.intercepted();
  }
  return std::min(1.0, met / intercepted);
}

long AzimuthLight::directions() const {
  return static_cast<long>(lights_.size() * prisms_.indices.size() * prisms_.prisms.size()) * (kPiece + 1);
}

}  // namespace parhelion
