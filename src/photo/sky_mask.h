// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "picture/photograph.h"

namespace parhelion {

/// How much of each pixel is sky: 0 none, 255 all of it; row-major, the photograph's size.
struct SkyMask {
  int width = 0;   // pixels
  int height = 0;  // pixels
  std::vector<std::uint8_t> sky;

  bool operator==(const SkyMask&) const = default;
};

/// A picture taken as a mask: white is sky, black is not, by the mean of its three components as the file has them
/// (floats: 0 to 1). Alpha does not matter.
SkyMask skyMaskOf(const Photograph& picture);

/// Reads a mask from any picture that readPhotograph reads. Throws std::runtime_error "path: reason".
SkyMask readSkyMask(const std::filesystem::path& path);

/// Writes a mask as grey levels that readSkyMask takes back to the same mask (.png; others as writePhotograph does).
/// Throws std::runtime_error "path: reason".
void writeSkyMask(const Output& output, const SkyMask& mask, const std::map<std::string, std::string>& text);

}  // namespace parhelion
