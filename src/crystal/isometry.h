// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "crystal/crystal_mesh.h"

namespace parhelion {

/// A rotation or reflection of the crystal's frame that takes a regular hexagonal prism to itself: y -> -y, then
/// z -> -z, where these are set, then a turn of `sixths` * 60 degrees about c.
struct Isometry {
  int sixths = 0;  // 0 ... 5
  bool flipsY = false, flipsZ = false;

  /// A rotation; if not, it takes crystals to their mirror images.
  bool isProper() const { return flipsY == flipsZ; }

  Vec3 operator()(const Vec3& v) const;

  bool operator==(const Isometry&) const = default;
};

/// The group of the hexagonal prism, D6h: 24 elements, the identity first.
std::array<Isometry, 24> hexagonalGroup();

/// What an isometry does to a crystal's faces: face i goes to the place of face images[i], both by their index in the
/// mesh. None if the crystal does not look the same afterwards.
std::optional<std::vector<int>> faceImages(const CrystalMesh& mesh, const Isometry& isometry);

}  // namespace parhelion
