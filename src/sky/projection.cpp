// SPDX-License-Identifier: Apache-2.0
#include "sky/projection.h"

#include "sky/projections.h"

namespace parhelion {

std::span<const Projection> allProjections() { return kProjections; }

std::string_view name(Projection projection) {
  return visitProjection(projection, [](auto p) { return p.name; });
}

std::optional<Projection> projectionNamed(std::string_view word) {
  for (const Projection projection : kProjections) {
    if (name(projection) == word) return projection;
  }
  return std::nullopt;
}

bool isFisheye(Projection projection) {
  return visitProjection(projection, [](auto p) { return p.isFisheye; });
}

}  // namespace parhelion
