// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

namespace parhelion {

/// The sRGB transfer function (IEC 61966-2-1) of a component in [0, 1].
double srgbEncode(double linear);

/// Its inverse.
double srgbDecode(double encoded);

/// The linear value of each code of 8 and of 16 bits, 0 to 1.
const std::array<float, 256>& srgbDecode8();
const std::array<float, 65536>& srgbDecode16();

/// The linear value of a sample: of a code of 8 or 16 bits, or of a float that is linear already.
inline float linearOf(std::uint8_t code) { return srgbDecode8()[code]; }
inline float linearOf(std::uint16_t code) { return srgbDecode16()[code]; }
inline float linearOf(float linear) { return linear; }

/// The code whose encoded value is nearest to that of `linear`, exactly: code + 1/2 belongs to the code above. Clipped
/// to [0, 1]; 0 for what is not finite. Takes decoded codes back to themselves. A few nanoseconds.
std::uint8_t toSrgb8(float linear);
std::uint16_t toSrgb16(float linear);

}  // namespace parhelion
