// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "picture/photograph.h"
#include "picture/tone.h"

namespace parhelion {

/// A picture as a screen shows it, in whatever way it came about: what the picture filters work on. Components are
/// through the sRGB transfer function, in [0, 1]; planes R, G, B, row-major from the top left.
struct Display {
  int width = 0;   // pixels
  int height = 0;  // pixels
  std::array<std::vector<float>, 3> planes;

  std::size_t pixels() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
};

/// A photograph of 8 or 16 bits as it is; where it has alpha, over black. Throws std::invalid_argument for linear
/// floats, which must be developed.
Display shown(const Photograph& photograph);

/// Linear light through exposure, tone curve and transfer function, as developPreview does it. Throws
/// std::invalid_argument if R, G or B is missing.
Display developed(const Image& image, const ToneSettings& settings);

/// 8 bits a component, dithered as developPreview does it; components that came from 8 bits come back unchanged.
Preview quantised(const Display& display);

/// 16 bits a component, interleaved.
std::vector<std::uint16_t> quantised16(const Display& display);

}  // namespace parhelion
