// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "scene/scene.h"
#include "trace/cloud.h"

namespace parhelion {

/// How many times as many rays each population should get as it has by its light, so that a scene's picture has the
/// least noise: in proportion to the square root of the noise that one ray of it makes (Neyman 1934), as a pilot run
/// finds it. Noise is the variance of a pixel over the square of its luminance, with a floor below a tenth of the mean,
/// summed over the picture. Between a quarter and four times, so that an unlucky pilot does little harm. Empty where
/// there is nothing to choose.
///
/// A function of the scene but for its number of rays, so that a run can be cut into parts and go on. `byLight` is the
/// scene's cloud without favours.
std::vector<double> favoursFor(const Scene& scene, const Cloud& byLight);

}  // namespace parhelion
