// SPDX-License-Identifier: Apache-2.0
#include "picture/chromaticities.h"

#include <array>
#include <cmath>
#include <cstdio>

namespace parhelion {
namespace {

// Files round to three or more decimals.
constexpr double kSamePlace = 1e-3;
// A change of gamma that no eye sees; libpng takes the same.
constexpr double kSameGamma = 0.05;

bool near(const Vec2& a, const Vec2& b) {
  return std::abs(a.x - b.x) <= kSamePlace && std::abs(a.y - b.y) <= kSamePlace;
}

}  // namespace

std::string chromaticitiesObjection(const Chromaticities& c) {
  const Chromaticities& rec709 = kRec709Chromaticities;
  if (near(c.red, rec709.red) && near(c.green, rec709.green) && near(c.blue, rec709.blue) &&
      near(c.white, rec709.white)) {
    return {};
  }
  std::array<char, 256> text{};
  std::snprintf(text.data(), text.size(),
                "its colours have the primaries red (%.4g, %.4g), green (%.4g, %.4g), blue (%.4g, %.4g) and white "
                "(%.4g, %.4g), not sRGB's",
                c.red.x, c.red.y, c.green.x, c.green.y, c.blue.x, c.blue.y, c.white.x, c.white.y);
  return text.data();
}

std::string gammaObjection(double exponent) {
  if (std::abs(exponent * 2.2 - 1.0) <= kSameGamma) return {};
  if (std::abs(exponent - 1.0) <= kSameGamma) return "its colours are linear (gamma 1), not sRGB";
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "its colours have gamma %.3g, not sRGB's", 1.0 / exponent);
  return text.data();
}

}  // namespace parhelion
