// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "view/display.h"

namespace parhelion {

/// Two pictures side by side, a grey gap of 4 pixels between them. The lower one is centred in the height of the other,
/// on black: a pixel stays a pixel.
Preview beside(const Preview& left, const Preview& right);

struct LightDifference {
  Display picture;
  double gain;
};

/// Linear light of `one` minus that of `other`, in each of R, G and B: times `gain` about mid-grey, without a transfer
/// function. Where `gain` is left out, 99.5 % of the pixels that differ come out between black and white; 0 where there
/// is no difference. Components that are not finite come out as mid-grey. Throws std::invalid_argument if the sizes
/// differ or a channel is missing.
LightDifference minus(const Image& one, const Image& other, std::optional<double> gain = std::nullopt);

}  // namespace parhelion
