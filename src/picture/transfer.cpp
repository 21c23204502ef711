// SPDX-License-Identifier: Apache-2.0
#include "picture/transfer.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "math/portable.h"

namespace parhelion {
namespace {

/// The encoded value as a polygon over the floats below 1: evenly spaced knots within each power of two, straight lines
/// between them. It is off by under 1e-6, so that at most the nearest threshold decides otherwise.
class EncodedPolygon {
 public:
  static constexpr float kDarkest = 0x1p-22F;  // code 0.2 of 65535

  EncodedPolygon() : knots_((kOne - kFirst) / kStep + 1) {
    for (std::uint32_t i = 0; i < knots_.size(); ++i) {
      knots_[i] = static_cast<float>(srgbEncode(std::bit_cast<float>(kFirst + i * kStep)));
    }
  }

  /// For kDarkest <= linear < 1.
  float operator()(float linear) const {
    const std::uint32_t above = std::bit_cast<std::uint32_t>(linear) - kFirst;
    const float* knot = knots_.data() + above / kStep;
    return knot[0] + (knot[1] - knot[0]) * (static_cast<float>(above % kStep) / kStep);
  }

 private:
  static constexpr std::uint32_t kStep = 1U << 15;  // of a float's 23 bits: 256 knots a power of two
  static constexpr std::uint32_t kFirst = std::bit_cast<std::uint32_t>(kDarkest);
  static constexpr std::uint32_t kOne = std::bit_cast<std::uint32_t>(1.0F);

  std::vector<float> knots_;
};

/// Codes by a guess and then the exact thresholds.
template <typename Code>
class SrgbEncoder {
 public:
  SrgbEncoder() : least_(kMost + 2) {
    for (int code = 1; code <= kMost; ++code) {
      const double threshold = srgbDecode((code - 0.5) / kMost);
      const auto rounded = static_cast<float>(threshold);
      least_[static_cast<std::size_t>(code)] = rounded < threshold ? std::nextafter(rounded, 1.0F) : rounded;
    }
    least_.back() = 1.0F;
  }

  Code operator()(float linear) const {
    if (!(linear > EncodedPolygon::kDarkest) || std::isinf(linear)) return 0;
    if (linear >= 1.0F) return kMost;
    auto code = static_cast<std::size_t>(polygon_(linear) * kMost + 0.5F);
    while (linear < least_[code]) --code;
    while (linear >= least_[code + 1]) ++code;
    return static_cast<Code>(code);
  }

 private:
  static constexpr Code kMost = std::numeric_limits<Code>::max();

  EncodedPolygon polygon_;
  std::vector<float> least_;  // the smallest float of each code; 1 ends the last
};

template <std::size_t Codes>
std::array<float, Codes> decoded() {
  std::array<float, Codes> linear{};
  for (std::size_t code = 0; code < Codes; ++code) {
    linear[code] = static_cast<float>(srgbDecode(static_cast<double>(code) / (Codes - 1)));
  }
  return linear;
}

}  // namespace

double srgbEncode(double linear) {
  if (linear <= 0.0031308) return 12.92 * std::max(linear, 0.0);
  return 1.055 * portable::exp(portable::log(linear) / 2.4) - 0.055;
}

double srgbDecode(double encoded) {
  if (encoded <= 0.04045) return std::max(encoded, 0.0) / 12.92;
  return portable::exp(2.4 * portable::log((encoded + 0.055) / 1.055));
}

const std::array<float, 256>& srgbDecode8() {
  static const auto table = decoded<256>();
  return table;
}

const std::array<float, 65536>& srgbDecode16() {
  static const auto table = decoded<65536>();
  return table;
}

std::uint8_t toSrgb8(float linear) {
  static const SrgbEncoder<std::uint8_t> encode;
  return encode(linear);
}

std::uint16_t toSrgb16(float linear) {
  static const SrgbEncoder<std::uint16_t> encode;
  return encode(linear);
}

}  // namespace parhelion
