// SPDX-License-Identifier: Apache-2.0
#include "optics/sun.h"

#include <cmath>

#include "math/portable.h"
#include "math/rotation.h"

namespace parhelion {

double limbDarkening(double r) {
  if (r > 1.0) return 0.0;
  const double mu = std::sqrt((1.0 - r) * (1.0 + r));
  return 0.26892 + mu * (1.34319 + mu * (-1.58427 + mu * (1.91271 + mu * (-1.31350 + mu * 0.37295))));
}

Sun::Sun(const SunSettings& settings)
    : toCentre_(skyDirection(0.0, settings.elevation)),
      frame_(frameAround(toCentre_)),
      angularRadius_(0.5 * settings.diameter),
      sinRadius_(portable::sin(angularRadius_)) {
  constexpr int kCells = 1024;  // of the disc's radius
  if (angularRadius_ > 0.0) radius_.emplace([](double r) { return r * limbDarkening(r); }, 0.0, 1.0, kCells);
}

SunDisc Sun::disc() const {
  const auto column = [&](int k) { return Triple<double>{frame_[k].x, frame_[k].y, frame_[k].z}; };
  return {radius_->quantile(), sinRadius_, column(0), column(1), column(2)};
}

double Sun::radiance(double angle) const {
  if (!radius_) return 0.0;
  const double r = portable::sin(angle) / sinRadius_;
  if (angle > 0.5 * kPi || r > 1.0) return 0.0;
  // d(solid angle) = sin da dphi = (sinRadius_^2 r / cos) dr dphi, and the table's integral is that of r *
  // limbDarkening.
  return limbDarkening(r) * portable::cos(angle) / (2.0 * kPi * sinRadius_ * sinRadius_ * radius_->integral());
}

}  // namespace parhelion
