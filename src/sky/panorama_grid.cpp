// SPDX-License-Identifier: Apache-2.0
#include "sky/panorama_grid.h"

#include "math/portable.h"
#include "sky/lens.h"

namespace parhelion {

PanoramaGrid::PanoramaGrid(const Camera& camera) {
  const Lens lens = camera.lens();
  const auto vector = [](const Triple<double>& v) { return Vec3(v.x, v.y, v.z); };
  const Vec3 right = vector(lens.right), forward = vector(lens.forward);
  up_ = vector(lens.up);
  focal_ = lens.focal;
  for (int i = 0; i <= 2 * camera.width(); ++i) {
    const auto [sine, cosine] = portable::sincos((0.5 * i - lens.centreX) / lens.focal);
    const bool showsSky = camera.toSky({0.5 * i, lens.centreY}).has_value();
    columns_.push_back({showsSky, cosine, sine * right + cosine * forward});
  }
  for (int i = 0; i <= 2 * camera.height(); ++i) {
    const auto [sine, cosine] = portable::sincos((lens.centreY - 0.5 * i) / lens.focal);
    const bool showsSky = camera.toSky({lens.centreX, 0.5 * i}).has_value();
    rows_.push_back({showsSky, cosine, sine * up_});
  }
}

}  // namespace parhelion
