// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "recon/recon_settings.h"
#include "scene/scene.h"
#include "sky/sky_tally.h"

namespace parhelion {

// What runs take, estimated before they start. The figures are measured, in bytes a pixel or bin.

/// A picture's size, whether it has colours or luminance alone, and of how many tallies it is made, those that layers
/// share among them.
struct SkySize {
  std::int64_t pixels = 0;
  bool colours = true;
  int tallies = 1;
  int layers = 0;         // of light, the rest among them
  int radialTallies = 0;  // of the tallies, that have rings about the sun
  int rings = 0;          // of each
};
SkySize skySizeOf(const Scene& scene);
SkySize skySizeOf(const SkyTally& tally);

// Memory at the peak, beyond what the program takes by itself: right to within a factor of 1.5. `threads` 0: one a
// processor.
std::uint64_t memoryToTrace(const SkySize& size, int threads);
std::uint64_t memoryToReconstruct(const SkySize& size, const ReconSettings& settings, int threads);

/// To trace and then to reconstruct.
std::uint64_t memoryToRender(const SkySize& size, const ReconSettings& settings, int threads);
std::uint64_t memoryToMap(int binsPerHalfTurn, int threads);
std::uint64_t memoryToProfile(int bins, int threads);
std::uint64_t memoryToIntegrate(int bins, int threads);
std::uint64_t memoryToIntegrate(const SkySize& size);

/// To set a halo, which takes `halo` bytes to be made, into a photograph of so many pixels, the photograph itself
/// aside.
std::uint64_t memoryToComposite(std::uint64_t pixels, std::uint64_t halo);
inline constexpr int kCompositeBytes = 36;  // a pixel, without the halo: sky, mask and the picture that is written

// Space on a disk, at least: how far files can be compressed depends on what is in them.
std::uint64_t leastBytesOfPicture(const SkySize& size, const ReconSettings& settings);
std::uint64_t leastBytesOfTally(const SkySize& size);
std::uint64_t leastBytesOfMap(int binsPerHalfTurn, bool asText);

}  // namespace parhelion
