// SPDX-License-Identifier: Apache-2.0
#include "sky/sky_view.h"

#include <algorithm>

#include "sky/camera.h"

namespace parhelion {
namespace {

double leastCosineOf(const Camera& camera, const Lens& lens) {
  CameraSettings whole = camera.settings();
  whole.horizon = Horizon::keep;
  const std::optional<Vec3> corner = Camera(whole).directionAt(camera.farthestCorner());
  if (!corner) return lens.minCosine;  // the image circle ends before
  // Far more than the lens shrinks its pictures by, and than what is lost where a distortion is undone.
  constexpr double kSlack = 1e-9;
  return std::max(lens.minCosine, lens.inFrame<double>({corner->x, corner->y, corner->z}).z - kSlack);
}

}  // namespace

SkyView::SkyView(const Camera& camera)
    : lens(camera.lens()),
      leastCosine(leastCosineOf(camera, lens)),
      isUpright(lens.up.x == 0.0 && lens.up.y == 0.0),
      fullTurn(2.0 * kPi * lens.focal * Lens::kShrink),
      mirrorSum(lens.centreX + lens.place<double>({lens.forward.x, -lens.forward.y, lens.forward.z}).x),
      // Angles are off by about 1e-15, and so are pixels, relative to a whole turn of them. A whole turn's seam, whose
      // light may be at either end, is off the picture's border by what it is shrunk, half of 1e-12.
      rounding(std::max(1e-9, 2e-12 * fullTurn)) {}

}  // namespace parhelion
