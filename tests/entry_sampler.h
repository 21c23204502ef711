// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "crystal/crystal.h"
#include "crystal/entry.h"

namespace parhelion {

/// Light that meets one convex crystal from outside; `lightDir` is a unit vector in the crystal's frame.
class EntrySampler {
 public:
  /// The crystal's mesh must outlive this.
  explicit EntrySampler(const Crystal& crystal) : faces_(*crystal.mesh), stretch_(crystal.stretch) {}

  /// The area of the crystal's shadow on a plane across the light.
  double projectedArea(const Vec3& lightDir) const { return shadows(lightDir).total; }

  /// A point of the lit side, uniform over the shadow, for three numbers in (0, 1).
  EntryPoint sample(const Vec3& lightDir, double u1, double u2, double u3) const {
    const double face = litFace(faces_, shadows(lightDir), u1);
    const auto [x, y, z] = pointOnFace(faces_, stretch_, face, u2, u3);
    return {static_cast<int>(face), {x, y, z}};
  }

 private:
  Shadows<double> shadows(const Vec3& lightDir) const {
    return castShadows(faces_, stretch_, Triple<double>{lightDir.x, lightDir.y, lightDir.z});
  }

  FaceTable faces_;
  double stretch_;
};

}  // namespace parhelion
