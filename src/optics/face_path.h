// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include "math/conventions.h"

namespace parhelion {

/// Where in the sky light of a sun toward `toSun` is seen (unit world vector) after a crystal of refractive index
/// `index` has sent it over faces with these outward unit normals, in world coordinates: in by the first, reflected
/// inside by those between, out by the last. A single face reflects it outside. None where a face is met from its wrong
/// side or lets no light out. Whether a crystal has room for such a path is not looked at.
std::optional<Vec3> seenOver(std::span<const Vec3> faces, const Vec3& toSun, double index);

}  // namespace parhelion
