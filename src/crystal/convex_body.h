// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "crystal/crystal_mesh.h"

namespace parhelion {

/// A half-space that a convex crystal lies in: normal . point <= distance.
struct FacePlane {
  int number;       // crystallographic (conventions.h)
  Vec3 normal;      // unit, outward
  double distance;  // from the origin, crystal units; negative where the origin lies outside
};

/// The crystal that the half-spaces have in common. Planes that it does not reach, or touches in no more than an edge,
/// are no faces. Of planes that coincide the first is the face. Faces have the planes' normals to the last bit.
///
/// Throws std::invalid_argument where the half-spaces have no volume in common, or are not closed, or where more than
/// kMaxFaces faces are left. Parts of the crystal that are smaller than 1e-11 of the largest distance are lost.
///
/// `keepAll`: planes that nothing is left of are faces without vertices, so that face i is that of plane i.
CrystalMesh convexBody(std::span<const FacePlane> planes, bool keepAll = false);

}  // namespace parhelion
