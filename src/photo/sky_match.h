// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "photo/halo_lookup.h"
#include "photo/sky_mask.h"
#include "picture/photograph.h"

namespace parhelion {

/// What the sky of a photograph is like where halos are seen.
struct SkyTone {
  double luminance = 0.0;  // mean, linear, white is 1
  Vec3 colour{1.0};        // mean linear R, G, B over that luminance
  bool aroundSun = false;  // of the sky within kSkyAroundSun of the sun; else of all the sky in the picture
};

/// How far from the sun the sky still counts as around it: a little beyond the 22-degree halo.
inline constexpr double kSkyAroundSun = radians(30.0);

/// The mean sky of a photograph within kSkyAroundSun of the sun, without clipped samples and partly masked pixels; of
/// all its sky where less than a hundredth of that lies there. Light sources are no sky: what is more than ten times as
/// bright as half of that sky, the sun's disc or a lamp, is left out with the glare about it, down to twice. Throws
/// std::invalid_argument where no sky can be measured.
SkyTone skyTone(const Photograph& photograph, const SkyMask& mask, const CameraSettings& camera, double sunElevation);

/// Luminance that the brightest hundredth of the photograph's sky, by the halo's light, has at least: 1/sr. 0 where
/// there is no halo in the sky.
double brightHalo(const HaloLookup& halo, const SkyMask& mask);

/// How strong a halo is to be in a photograph, and of which colour.
struct HaloStrengthSettings {
  std::optional<double> strength;  // linear samples (white is 1) per 1/sr; none: by contrast
  double contrast = 0.5;           // luminance of the halo's bright parts over the sky's: what nobody overlooks
  std::optional<Vec3> white{1.0};  // R, G, B of white in the halo, as bright as may be; none: that of the sky
};

struct HaloStrength {
  Vec3 perRadiance;                  // R, G, B; what one unit of the halo's radiance adds to linear samples
  std::vector<std::string> remarks;  // what was chosen
};

/// Throws std::invalid_argument where the sky must be measured and cannot be.
HaloStrength haloStrength(const HaloStrengthSettings& settings, const Photograph& photograph, const SkyMask& mask,
                          const CameraSettings& camera, double sunElevation, const HaloLookup& halo);

}  // namespace parhelion
