// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "recon/adaptive/scatter.h"

namespace parhelion {

/// Shapes of the kernels that suit a picture: long where it changes in one direction only, as along an arc.
/// `density` is the pilot, hits per relative solid angle, made with kernels of `hits` hits. Where it changes nowhere,
/// kernels are round in the sky. Pixels without sky are round.
///
/// From the structure tensor of log(density) over windows much wider than the pilot's kernels. Where windows are as
/// small as these, noise looks like arcs everywhere.
Raster<KernelShape> kernelShapes(const SkyPyramid& sky, const Raster<Light<1>>& density, double hits);

}  // namespace parhelion
