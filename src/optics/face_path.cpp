// SPDX-License-Identifier: Apache-2.0
#include "optics/face_path.h"

#include <cmath>

#include <glm/geometric.hpp>

namespace parhelion {

// Light inside is a vector as long as the refractive index: refraction then keeps its part along the face, and its part
// along the normal follows from its length.

std::optional<Vec3> seenOver(std::span<const Vec3> faces, const Vec3& toSun, double index) {
  const double excess = (index - 1.0) * (index + 1.0);
  const double entry = glm::dot(toSun, faces.front());
  if (!(entry > 0.0)) return std::nullopt;
  if (faces.size() == 1) return toSun - 2.0 * entry * faces.front();
  Vec3 light = -toSun + (entry - std::sqrt(entry * entry + excess)) * faces.front();
  for (const Vec3& normal : faces.subspan(1, faces.size() - 2)) {
    const double toward = glm::dot(light, normal);
    if (!(toward > 0.0)) return std::nullopt;
    light -= 2.0 * toward * normal;
  }
  const double exit = glm::dot(light, faces.back());
  if (!(exit > 0.0 && exit * exit >= excess)) return std::nullopt;
  return -(light + (std::sqrt(exit * exit - excess) - exit) * faces.back());
}

}  // namespace parhelion
