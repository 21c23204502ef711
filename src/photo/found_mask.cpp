// SPDX-License-Identifier: Apache-2.0
#include "photo/found_mask.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "parallel/loops.h"
#include "sky/camera.h"

namespace parhelion {
namespace {

constexpr const char* kSumKey = "parhelion:mask";

// rad below the horizon: what a wrong roll or lens may shift it by at the border of a wide picture.
constexpr double kFarBelow = radians(5.0);

/// FNV-1a of 64 bits over the mask's pixels.
std::string sumOf(const SkyMask& mask) {
  std::uint64_t sum = 0xCBF29CE484222325u;
  for (const std::uint8_t sky : mask.sky) sum = (sum ^ sky) * 0x100000001B3u;
  return std::to_string(sum);
}

}  // namespace

void cutBelowHorizon(SkyMask& mask, const CameraSettings& settings) {
  constexpr int kBlock = 8;  // pixels a side, decided as one
  const Camera camera(settings);
  const double lowest = -std::sin(kFarBelow);
  forEach((mask.height + kBlock - 1) / kBlock, [&](int row) {
    const int top = row * kBlock, bottom = std::min(mask.height, top + kBlock);
    for (int left = 0; left < mask.width; left += kBlock) {
      const int right = std::min(mask.width, left + kBlock);
      const auto toSky = camera.toSky(0.5 * Vec2(left + right, top + bottom));
      if (!toSky || toSky->z >= lowest) continue;
      for (int y = top; y < bottom; ++y) {
        const auto pixels = mask.sky.begin() + static_cast<std::ptrdiff_t>(y) * mask.width;
        std::fill(pixels + left, pixels + right, std::uint8_t{0});
      }
    }
  });
}

void writeFoundMask(const Output& output, const SkyMask& mask, const std::string& software) {
  writeSkyMask(output, mask, {{"Software", software}, {kSumKey, sumOf(mask)}});
}

void requireUnchangedMask(const std::filesystem::path& path) {
  if (!std::filesystem::is_regular_file(path)) return;
  const auto corrected = [&] {
    const Photograph picture = readPhotograph(path, {true});
    const auto sum = picture.text.find(kSumKey);
    return sum == picture.text.end() || sum->second != sumOf(skyMaskOf(picture));
  };
  bool isTheirs = true;
  try {
    isTheirs = corrected();
  } catch (const std::runtime_error&) {  // no picture: not ours either
  }
  if (isTheirs)
    throw std::runtime_error(path.string() +
                             ": is there and is no mask as it was found; give it with --mask, or name another place "
                             "for the one to be found with --mask-out, or say --overwrite");
}

}  // namespace parhelion
