// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "image/image.h"
#include "image/tally.h"
#include "recon/recon_settings.h"

namespace parhelion {

/// Turns scattered hits into a whole image of the sky in 1/sr: channels R, G, B and the variance of the luminance
/// (image/radiance.h). The undeviated sunlight is not in it.
Image reconstruct(const Tally& tally, const ReconSettings& settings);

}  // namespace parhelion
