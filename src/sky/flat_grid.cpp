// SPDX-License-Identifier: Apache-2.0
#include "sky/flat_grid.h"

#include "sky/lens.h"

namespace parhelion {

FlatGrid::FlatGrid(const Camera& camera) {
  const Lens lens = camera.lens();
  const auto vector = [](const Triple<double>& v) { return Vec3(v.x, v.y, v.z); };
  const Vec3 right = vector(lens.right), up = vector(lens.up);
  forward_ = vector(lens.forward);
  for (int i = 0; i <= 2 * camera.width(); ++i) {
    const double x = (0.5 * i - lens.centreX) / lens.focal;
    columns_.push_back({x, x * right});
  }
  for (int i = 0; i <= 2 * camera.height(); ++i) {
    const double y = (lens.centreY - 0.5 * i) / lens.focal;
    rows_.push_back({y, y * up});
  }
}

}  // namespace parhelion
