// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "view/display.h"

namespace parhelion {

/// The value a difference of nothing is shown as: the middle of 8 bits.
inline constexpr double kMidGrey = 128.0 / 255.0;

struct ColourDifference {
  Display picture;
  double centre;  // red minus blue that came out as mid-grey, in display values
  double gain;    // of what is above and below
};

/// Observers' R-B: red minus blue of the values a screen shows, as grey; the colours of halos and coronae stand out of
/// clouds, which have none. The median over the sky is mid-grey, redder is lighter. Where `gain` is left out, the
/// difference's percentiles 1 and 99, whichever is farther from the median, come out as black or white; 0 where there
/// is no difference. `sky`, if not empty, says of each pixel whether it counts (128 and more) for median and
/// percentiles; black pixels never do. Throws std::invalid_argument if it has another size than the picture or nothing
/// counts by it.
ColourDifference redMinusBlue(Display picture, std::optional<double> gain = std::nullopt,
                              std::span<const std::uint8_t> sky = {});

}  // namespace parhelion
