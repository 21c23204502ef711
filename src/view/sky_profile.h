// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "picture/image.h"
#include "sky/camera.h"

namespace parhelion {

struct SkyProfileSettings {
  double from = 0.0;           // rad from the sun
  double to = radians(60);     // rad
  double bin = radians(0.25);  // rad; the last bin ends at `to`
};

/// Light at some angle from the sun. Means are over the bin's pixels that show sky, by solid angle.
struct SkyProfileBin {
  double from, to;          // rad
  Vec3 mean{0.0};           // linear R, G, B as in the picture
  double luminance = 0.0;   // of Rec.709
  double error = 0.0;       // standard error of `luminance` from the scatter of the pixels, as if independent
  std::int64_t pixels = 0;  // whose centre lies in the bin; where there are none the means say nothing
};

/// Profile of a picture around the sun. `share`, if not empty, says how much each pixel counts (0 none, 255 all).
/// Pixels that are not finite do not count. Solid angles are those of flat quadrangles between the directions of the
/// pixel's corners: 1e-3 or better for pixels below 5 degrees. Throws std::invalid_argument for a size that is not the
/// camera's, a missing channel, and for settings other than 0 <= from < to <= pi, bin > 0 and at most kMaxProfileBins.
std::vector<SkyProfileBin> skyProfile(const Image& picture, const Camera& camera, const Vec3& toSun,
                                      const SkyProfileSettings& settings, std::span<const std::uint8_t> share = {});

inline constexpr int kMaxProfileBins = 1'000'000;

/// For pictures of different cameras: `share` of each pixel of `camera` (all of it if empty) where its centre is seen
/// by `other` too, in a pixel that counts there (`otherShare` of 128 or more, or empty); else 0.
std::vector<std::uint8_t> sharedSky(const Camera& camera, std::span<const std::uint8_t> share, const Camera& other,
                                    std::span<const std::uint8_t> otherShare);

}  // namespace parhelion
