// SPDX-License-Identifier: Apache-2.0
#include "picture/colour_space.h"

#include <cmath>

#include <glm/matrix.hpp>

namespace parhelion {
namespace {

Vec3 xyzFromChromaticity(double x, double y) { return {x / y, 1.0, (1.0 - x - y) / y}; }

Mat3 diagonal(const Vec3& d) { return {d.x, 0.0, 0.0, 0.0, d.y, 0.0, 0.0, 0.0, d.z}; }

// ITU-R BT.709: D65 white and the primaries' chromaticities.
const Vec3 kD65 = xyzFromChromaticity(0.3127, 0.3290);

Mat3 rec709ToXyz() {
  const Mat3 primaries{xyzFromChromaticity(0.64, 0.33), xyzFromChromaticity(0.30, 0.60),
                       xyzFromChromaticity(0.15, 0.06)};
  return primaries * diagonal(glm::inverse(primaries) * kD65);
}

// Bradford cone responses (Lam 1985; CIE 159:2004, eq. 6). GLM takes columns, the source gives rows.
const Mat3 kBradford = glm::transpose(Mat3{0.8951, 0.2664, -0.1614, -0.7502, 1.7135, 0.0367, 0.0389, -0.0685, 1.0296});

}  // namespace

Mat3 xyzToRec709() { return glm::inverse(rec709ToXyz()); }

Mat3 xyzToRec709(const Vec3& white) {
  const Mat3 toRec709 = xyzToRec709();
  const Vec3 from = kBradford * white, to = kBradford * kD65;
  if (!(from.x > 0.0 && from.y > 0.0 && from.z > 0.0)) return toRec709;

  const Mat3 adapted = toRec709 * glm::inverse(kBradford) * diagonal(to / from) * kBradford;
  return diagonal(1.0 / (adapted * white)) * adapted;  // takes away the last rounding error of the white
}

Mat3 rec709ToXyz(const Vec3& white) { return glm::inverse(xyzToRec709(white)); }

std::optional<Mat3> rgbToRec709(const Chromaticities& from) {
  // Unlike xyzFromChromaticity() also for y = 0, as in camera spaces and in ACES, whose blue has y < 0.
  const auto xyz = [](const Vec2& c) { return Vec3(c.x, c.y, 1.0 - c.x - c.y); };
  const Mat3 primaries{xyz(from.red), xyz(from.green), xyz(from.blue)};
  const Vec3 white = xyz(from.white) / from.white.y;
  const Vec3 amounts = glm::inverse(primaries) * white;
  const bool isAmong = amounts.x > 0.0 && amounts.y > 0.0 && amounts.z > 0.0;
  if (!isAmong || !std::isfinite(amounts.x + amounts.y + amounts.z) || !(from.white.y > 0.0)) return std::nullopt;
  return xyzToRec709(white) * primaries * diagonal(amounts);
}

}  // namespace parhelion
