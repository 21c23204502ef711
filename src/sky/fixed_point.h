// SPDX-License-Identifier: Apache-2.0
#pragma once

// Sums of light as exact integers. Integer addition is associative, so any number of threads and any order of merging
// give the same bits, and a bin never stalls as a float does at 2^24. Light that does not fit throws
// std::overflow_error: no sum is ever wrong without a word.

#include <cmath>
#include <cstdint>
#include <stdexcept>

#include "math/conventions.h"
#include "math/exact_sum.h"

namespace parhelion {

/// Units per unit of light, the light one ray brings on average. Rounding a deposit is off by at most 2^-29 of it.
/// 3e10 rays make 8.1e18 < 2^63 = 9.2e18 even if all fall into one bin.
inline constexpr double kWeightScale = 0x1p28;

/// A total of a run, in the same units. 128 bits hold the light of 2^99 rays.
using LightTotal = FixedSum<28>;
static_assert(LightTotal::kScale == kWeightScale);

/// Units per squared unit of light. Coarser, because one wavelength a ray makes the mean square of its luminance as
/// large as 2.7 (the 1931 observer over an equal spectrum): 3e10 rays may bring a mean square of 4.5. Bundles of more
/// than four rays that are all of one bin bring more: then fewer rays fit.
inline constexpr double kSquareScale = 0x1p26;
using SquareTotal = FixedSum<26>;
static_assert(SquareTotal::kScale == kSquareScale);

[[noreturn]] inline void rejectLight() {
  throw std::overflow_error(
      "more light in one place than a tally can hold (64 bits): trace fewer rays at a time, or give sun.spectrum fewer "
      "wavelengths");
}

/// `light * scale` rounded to the nearest integer. Throws std::overflow_error where that is not below 2^63.
inline std::int64_t toFixed(double light, double scale = kWeightScale) {
  const double units = light * scale;
  if (!(std::abs(units) < 0x1p63)) rejectLight();
  return static_cast<std::int64_t>(units + std::copysign(0.5, units));  // the cast cuts toward zero
}

/// Adds to a sum. Throws std::overflow_error where the result does not fit.
inline void addFixed(std::int64_t& sum, std::int64_t amount) {
  if (__builtin_add_overflow(sum, amount, &sum)) rejectLight();
}

/// The total of many amounts, several times as fast as adding each to a LightTotal: in 64 bits as long as they fit.
class ManyAmounts {
 public:
  void add(std::int64_t amount) {
    std::int64_t sum = 0;
    if (__builtin_add_overflow(some_, amount, &sum)) {
      others_.addUnits(some_);
      sum = amount;
    }
    some_ = sum;
  }
  LightTotal total() const {
    LightTotal all = others_;
    all.addUnits(some_);
    return all;
  }

 private:
  std::int64_t some_ = 0;
  LightTotal others_;
};

/// Light in units of kWeightScale, X and Z over the white's: what one exit, or all exits of a bundle, bring to a place.
/// Exits are rounded one by one, so that it does not matter how they are told apart.
struct FixedLight {
  std::int64_t x = 0, y = 0, z = 0;

  FixedLight& operator+=(const FixedLight& more) {
    addFixed(x, more.x);
    addFixed(y, more.y);
    addFixed(z, more.z);
    return *this;
  }
  bool operator==(const FixedLight&) const = default;

  /// The square of the luminance, in units of kSquareScale.
  std::int64_t squared() const {
    const double luminance = static_cast<double>(y) / kWeightScale;
    return toFixed(luminance * luminance, kSquareScale);
  }
};

/// 1 over a white's XYZ for toFixedLight(), whose luminances have a unit of their own; 0 for light that is not there.
inline Vec3 perWhiteOf(const Vec3& white) {
  const auto inverseOrZero = [](double x) { return x > 0.0 ? 1.0 / x : 0.0; };
  return {inverseOrZero(white.x), 1.0, inverseOrZero(white.z)};
}

/// Light in CIE XYZ; `perWhite` is 1 over the white's.
template <class Vector>
FixedLight toFixedLight(const Vector& xyz, const Vector& perWhite) {
  return {toFixed(xyz.x * perWhite.x), toFixed(xyz.y), toFixed(xyz.z * perWhite.z)};
}

inline double fromFixed(std::int64_t sum, double scale = kWeightScale) { return static_cast<double>(sum) / scale; }

}  // namespace parhelion
