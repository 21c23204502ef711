// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "recon/hit_map.h"

namespace parhelion {

/// How the size of a method's filter (pixels) follows the hits: factor * sqrt(pixels of the sky) * hits^-exponent, at
/// least `least`.
struct SizeRule {
  double factor, exponent, least;
};

// What suits each method, ACT with 3 iterations and the others with none: the error is within a fifth of the least for
// skies with halos, from 4e3 to 4e6 hits. A kernel narrower than the least is a single pixel.
inline constexpr SizeRule kGaussianSigma{0.074, 0.224, 0.25};
inline constexpr SizeRule kMarvastiPeriod{0.235, 0.221, 1.0};
inline constexpr SizeRule kVoronoiPeriod{0.042, 0.11, 1.0};
inline constexpr SizeRule kActPeriod{0.238, 0.27, 1.0};

/// The size for a hit map, pixels. Hits are those of the first light.
double sizeByHits(const HitMap& map, const SizeRule& rule);

/// A remark: "sigma 3.27 px".
std::string sizeRemark(const std::string& name, double pixels);

}  // namespace parhelion
