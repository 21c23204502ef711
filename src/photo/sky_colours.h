// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "picture/image.h"
#include "picture/raster.h"

namespace parhelion {

/// Lightness, red less green, blue less yellow, of square roots of exposed linear components: steps look about equal.
using Opponent = std::array<float, 3>;

float squaredDistance(const Opponent& a, const Opponent& b);

/// What the finder of the sky looks at: a small picture as opponent colours.
struct SkyScene {
  Raster<Opponent> colours;
  float step = 0.0F;  // smallest difference of neighbours that means something: to be seen, and above the noise
};

/// Exposes a linear picture by its bright parts (so that any unit will do) and measures its noise.
SkyScene skyScene(const Image& linear);

/// How often colours occur, in boxes that overlap by half so that a small change of colour changes little.
class ColourHistogram {
 public:
  ColourHistogram();
  void add(const Opponent& colour);
  double total() const { return total_; }
  /// Share of the pixels, per box, about this colour; never 0.
  double density(const Opponent& colour) const;
  /// How much a pixel's colour tells which of two sets it is from: mutual information over entropy, from 0 (nothing)
  /// to 1 (all).
  static double separation(const ColourHistogram& a, const ColourHistogram& b);

 private:
  std::vector<float> boxes_;
  double total_ = 0.0;
};

}  // namespace parhelion
