// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace parhelion {

/// How scattered hits become an image.
enum class ReconMethod {
  none,      // the plain radiance: each pixel's light over its solid angle
  adaptive,  // filters as wide and as long as each place of the sky allows (recon/adaptive.h)
};

struct ReconSettings {
  ReconMethod method = ReconMethod::adaptive;
};

}  // namespace parhelion
