// SPDX-License-Identifier: Apache-2.0
#include "sky/flat_grid.h"

#include <doctest/doctest.h>

using namespace parhelion;

TEST_CASE("a flat grid has the camera's directions of all corners and centres, to the bit") {
  CameraSettings settings;
  settings.projection = Projection::rectilinear;
  settings.azimuth = 0.3;
  settings.elevation = 0.2;
  settings.roll = 0.1;
  settings.fieldOfView = 1.2;
  settings.width = 13;
  settings.height = 7;
  settings.shift = {0.1, -0.05};
  const Camera camera(settings);
  const FlatGrid grid(camera);
  for (int y = 0; y <= 2 * camera.height(); ++y)
    for (int x = 0; x <= 2 * camera.width(); ++x) CHECK(grid.toSky(x, y) == camera.directionAt({0.5 * x, 0.5 * y}));
}
