// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace parhelion {

/// What speaks against taking a picture with this ICC profile for sRGB: "" if the profile means sRGB within two steps
/// of 8 bits (for a grey picture also its transfer function alone, or a power of 2.2, which is commonly used in its
/// place), else "its colours are in the profile "Adobe RGB (1998)", not sRGB" or "its colours are in a damaged
/// profile".
std::string profileObjection(std::span<const std::uint8_t> profile, bool grey);

/// An ICC profile of sRGB, the same bytes each time.
std::vector<std::uint8_t> srgbProfile();

}  // namespace parhelion
