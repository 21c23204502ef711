// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "picture/image.h"
#include "recon/recon_settings.h"
#include "recon/watch.h"
#include "sky/sky_tally.h"

namespace parhelion {

/// A whole image of the sky in 1/sr. Its channels are R, G, B and the variance of the luminance (sky/radiance.h). The
/// undeviated sunlight is not in it.
///
/// The variance is that of the noise, measured by the difference between the pictures of the two halves of the rays. It
/// does not include the systematic error of a filter, such as blur. The adaptive method estimates that, too, in a
/// channel of its own.
struct ReconstructedSky {
  Image image;
  std::vector<std::string> remarks;  // for the user, such as which sizes were chosen or that an iteration was stopped
};

/// Turns scattered hits into an image of the sky. The type of the settings chooses the method. The same tally and
/// settings give the same bits for any number of threads. Throws ReconStopped (recon/watch.h) if asked to stop.
ReconstructedSky reconstruct(const Tally& tally, const ReconSettings& settings, const Watch& watch = {});

/// Adds the picture of a part to that of all, `gain` times, and to that of its layer, where it has a name. Noise and
/// biases are taken as independent.
void addPart(const Image& part, double gain, const std::string& layer, Image& all);

/// How much each layer counts in a picture, by name; 1 where it is not named.
using LayerGains = std::map<std::string, double, std::less<>>;

/// Reconstructs each part of a tally by itself, with its own noise, and adds them. Of a tally with layers the picture
/// has channels NAME.R, NAME.G, NAME.B for each, with its gain, whose sums are R, G, B; layers of gain 0 are left out.
/// The noise of parts is taken as independent. Throws as reconstruct() does.
ReconstructedSky reconstruct(const SkyTally& tally, const ReconSettings& settings, const LayerGains& gains = {},
                             const Watch& watch = {});

}  // namespace parhelion
