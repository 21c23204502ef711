// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "trace/cloud.h"
#include "trace/ray_pool.h"

namespace parhelion::bench {

/// Randomly oriented hexagonal prisms of one aspect ratio under a point sun 20 degrees high, 550 nm.
Cloud randomPrisms(double aspect);

/// A ray inside a crystal on its way to the next face; crystal frame.
struct InteriorRay {
  Vec3 point, lightDir;
  int leftFace;  // index of the face it starts on
};

/// Calls `look` with the interior rays of the real paths first ... last - 1 of a cloud of one crystal shape, path after
/// path; seed 1, planes in double precision.
void forEachInteriorRay(const Cloud& cloud, std::uint64_t first, std::uint64_t last,
                        const std::function<void(const InteriorRay&)>& look);

/// The first `count` of them.
std::vector<InteriorRay> interiorRays(const Cloud& cloud, std::size_t count);

/// Puts rays into a pool, at most as many as it has room for, as those of crystals of one stretch.
void fillPool(RayPool& pool, std::span<const InteriorRay> rays, double stretch);

/// The crystal that all of a cloud's rays meet; of clouds of one crystal shape.
Crystal onlyCrystal(const Cloud& cloud);

}  // namespace parhelion::bench
