// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "picture/image.h"
#include "picture/photograph.h"

namespace parhelion {

/// What the painted photographs show.
enum class Landscape {
  ridges,        // three ridges below a clear sky
  haze,          // six ridges, the farthest a few per cent from the colour of the sky
  bareTrees,     // trees without leaves against a clear sky
  leafyTrees,    // crowns with gaps
  brightClouds,  // white clouds of hard edges, land in the sun
  darkClouds,    // clouds darker than parts of the land
  sunset,        // low sun with its glow, streaks of cloud, land in silhouette
  snow,          // mountains as bright as the sky
  lake,          // water that mirrors sky and ridges
  sea,           // a level horizon
  town,          // houses, some of their walls as bright as the sky
};

inline constexpr std::array kLandscapes{Landscape::ridges,     Landscape::haze,         Landscape::bareTrees,
                                        Landscape::leafyTrees, Landscape::brightClouds, Landscape::darkClouds,
                                        Landscape::sunset,     Landscape::snow,         Landscape::lake,
                                        Landscape::sea,        Landscape::town};

std::string_view nameOf(Landscape kind);

/// A photograph of which is known what is sky.
struct Scenery {
  Image picture;           // linear, with the noise and the 8 bits of a camera
  std::vector<float> sky;  // 0 to 1, how much of each pixel
};

/// Paints one of the landscapes, another with each seed.
Scenery paintLandscape(Landscape kind, std::uint64_t seed, int width, int height);

/// The same as a file of 8 bits holds it.
Photograph photographOf(const Image& linear);

/// Intersection over union of two skies, both cut at one half.
double overlap(const std::vector<float>& truth, const std::vector<std::uint8_t>& mask);

}  // namespace parhelion
