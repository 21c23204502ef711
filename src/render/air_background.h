// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "picture/image.h"
#include "render/slab_light.h"
#include "scene/scene.h"
#include "sky/camera.h"
#include "sky/tally_info.h"

namespace parhelion {

/// The sun as its light reaches the crystals, which float around the observer: reddened where the scene has air. How
/// bright it is then is not in it; below the horizon its colour is that above the air.
SunSettings sunAtCloud(const Scene& scene);

/// Puts a finished picture of a halo, 1/sr, into absolute units and adds what is behind it: the sky, the ground and, if
/// it is visible, the sun. Linear Rec.709 with Y in cd/m^2; nothing is adapted to the light of the sun. Layers get the
/// units alone. The crystals are in the scene's cloud, or in one of optical depth 0.05 where it has none. The cloud
/// dims the sun, the sky behind it and the ground under it (clouded_sky.h). `info` is that of the picture's tally.
/// `threads` 0: one a processor.
void addAir(Image& image, const Camera& camera, const TallyInfo& info, const Scene& scene, int threads);

/// The same where the light of the scene's cloud is known. `more` is light that was scattered more than once, in cd/m^2
/// as if there were no air; it may be null.
void addAir(Image& image, const Camera& camera, const TallyInfo& info, const Scene& scene, int threads,
            const SlabLight& slab, const Image* more);

}  // namespace parhelion
