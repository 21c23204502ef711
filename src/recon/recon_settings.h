// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace parhelion {

/// How scattered hits become an image.
enum class ReconMethod {
  none,      // the plain radiance: each pixel's light over its solid angle
  adaptive,  // filters as wide as each place of the sky allows
};

struct ReconSettings {
  ReconMethod method = ReconMethod::none;
};

}  // namespace parhelion
