// SPDX-License-Identifier: Apache-2.0
#include "beam/light_class.h"

#include <algorithm>
#include <cmath>

#include "math/portable.h"

namespace parhelion {

namespace {

constexpr double kAside = 2e-4, kPlanesApart = kPi / 6.0;  // rad

/// An azimuth at which no light goes round for ever, on the side of `towards`.
double besidePlanes(double phi, double towards) {
  const double plane = std::round(phi / kPlanesApart) * kPlanesApart;
  if (std::abs(phi - plane) >= kAside) return phi;
  return towards > plane ? plane + kAside : plane - kAside;
}

Vec3 vectorOf(const Triple<double>& v) { return {v.x, v.y, v.z}; }

}  // namespace

Triple<double> lightDirAt(double phi, double zeta) {
  const auto [sinPhi, cosPhi] = portable::sincos(phi);
  const auto [sinZeta, cosZeta] = portable::sincos(zeta);
  return {sinZeta * cosPhi, sinZeta * sinPhi, -cosZeta};
}

TracedDirection tracedDirection(double phi, double zeta, double towards) {
  constexpr double kAcross = 0.5 * kPi;
  const double besidePhi = besidePlanes(phi, towards),
               besideZeta = zeta <= kAcross ? std::clamp(zeta, kAside, kAcross - kAside)
                                            : std::clamp(zeta, kAcross + kAside, kPi - kAside);
  return {vectorOf(lightDirAt(besidePhi, besideZeta)), vectorOf(lightDirAt(phi, zeta)),
          besidePhi != phi || besideZeta != zeta};
}

}  // namespace parhelion
