// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <functional>
#include <optional>

#include "recon/reconstruct.h"
#include "render/slab_light.h"
#include "scene/parse_scene.h"
#include "trace/trace_orders.h"

namespace parhelion {

/// How walks through a cloud are watched. A stop that was asked for before they begin does not shorten them.
struct WalkWatch {
  const std::atomic<bool>* stop = nullptr;                       // makes do with fewer walks
  std::function<void(double share, double seconds)> onProgress;  // from the calling thread; may be empty
};

/// Light that a cloud scatters twice and more.
struct MoreOrders {
  Image image;  // cd/m^2, with the channels that the picture of the scene has
  OrderReport report;
};

/// Walks for each ray of a picture.
inline constexpr std::uint64_t kRaysPerWalk = 16;

/// That of a scene whose picture was made of so many rays; 0: as many as the scene has. None for a scene without a
/// cloud, or one whose light is scattered once only, or before sunrise. `slab` is the scene's; `gains` are those of its
/// layers. `threads` 0: one a processor. The same bits for any number of threads.
std::optional<MoreOrders> moreOrders(const LoadedScene& loaded, std::uint64_t rays, const SlabLight& slab,
                                     const LayerGains& gains, int threads, const WalkWatch& watch = {});

/// Makes the picture of single crystals, per unit of the light that they intercept, one of a cloud with haze of which
/// haze intercepts the share `ofHaze`: per unit of what both intercept.
void addHaze(Image& image, const Camera& camera, const Scene& scene, double ofHaze);

}  // namespace parhelion
