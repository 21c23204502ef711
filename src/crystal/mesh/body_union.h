// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "crystal/convex_body.h"

namespace parhelion {

/// The crystal that convex bodies, each by the planes of its faces (convexBody()), are together. Where bodies overlap,
/// their faces end at each other; where faces of two bodies touch face to face, both are gone; where two lie in one
/// plane, looking to the same side, the common part is the earlier body's. Faces have the planes' numbers and, to the
/// last bit, their normals. A single body is as convexBody() makes it.
///
/// Bodies that meet in corners or edges alone, all of them, stay bodies by themselves, which light cannot pass between.
///
/// Throws std::invalid_argument where a body is none; where some bodies have a volume or a face in common, and parts of
/// the surface meet in nothing but a corner or an edge; and where they come closer than 1e-9 of the crystal's size.
CrystalMesh unionOf(std::span<const std::vector<FacePlane>> bodies);

}  // namespace parhelion
