// SPDX-License-Identifier: Apache-2.0
#include "view/layer_places.h"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

#include "math/rotation.h"
#include "view/overlays.h"

using namespace parhelion;

namespace {

/// A picture of one layer "a", which has this light at each place.
template <class Light>
Image layered(int size, Light&& light) {
  Image image{size, size, {}};
  for (const char* name : {"a.R", "a.G", "a.B"}) {
    std::vector<float>& samples = image.add(name);
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x)
        samples[static_cast<std::size_t>(y * size + x)] = static_cast<float>(light(Vec2(x + 0.5, y + 0.5)));
  }
  return image;
}

}  // namespace

TEST_CASE("a layer's place is where its own light is brightest, and not below the horizon unless that is asked for") {
  const Camera camera(cameraOf(Projection::fisheyeEqualArea, 0, 0, 180, 400, 400));
  const Vec2 above = camera.project(skyDirection(radians(20), radians(30))).value();
  const Vec2 below = camera.project(skyDirection(radians(-40), radians(-30))).value();
  const Image image = layered(400, [&](Vec2 at) {
    return glm::distance(at, above) < 6.0 ? 1.0 : glm::distance(at, below) < 6.0 ? 2.0 : 0.01;
  });
  CHECK(glm::distance(brightestPlace(image, "a", camera, false).value(), above) < 6.0);
  CHECK(glm::distance(brightestPlace(image, "a", camera, true).value(), below) < 6.0);
  CHECK_FALSE(brightestPlace(layered(400, [](Vec2) { return 0.0; }), "a", camera, true));
  CHECK_FALSE(brightestPlace(layered(400, [](Vec2 at) { return 1.0 + 1e-3 * at.x; }), "a", camera, true));
  CHECK_THROWS_AS(brightestPlace(image, "b", camera, true), std::invalid_argument);
}

TEST_CASE("names of places stand in place of the names of halos") {
  OverlaySettings s = everything();
  const CameraSettings sky = wholeSky(800);
  REQUIRE(hasLabel(overlay(sky, radians(20), kIndex, s), "circumzenithal arc"));
  s.names = {{"the layer", Vec2(300, 500)}};
  const Overlay named = overlay(sky, radians(20), kIndex, s);
  CHECK(hasLabel(named, "the layer"));
  CHECK_FALSE(hasLabel(named, "circumzenithal arc"));
  for (const PlacedLabel& label : named.labels) {
    if (label.text != "the layer") continue;
    CHECK(glm::distance(glm::clamp(Vec2(300, 500), label.box.min, label.box.max), Vec2(300, 500)) < 150.0);
  }
  s.labels = false;
  CHECK_FALSE(hasLabel(overlay(sky, radians(20), kIndex, s), "the layer"));
}
