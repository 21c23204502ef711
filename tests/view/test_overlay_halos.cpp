// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "view/overlays.h"

using namespace parhelion;

TEST_CASE("nothing is drawn or named below the horizon of a photograph") {
  OverlaySettings s = everything();
  s.belowHorizon = false;
  const CameraSettings settings = cameraOf(Projection::rectilinear, 0, 0, 90, 800, 600);
  const Overlay photo = overlay(settings, radians(20), kIndex, s);
  // The horizon's own width, and the legend in a corner.
  long below = 0;
  forEachDrawn(photo.lines, [&](const Vec2& p, int) { below += p.y > 304.0 && p.x > 260.0 && p.x < 540.0; });
  CHECK(below == 0);
  for (const PlacedLabel& label : photo.labels) CHECK(label.box.max.y <= 300.5);
  CHECK(!hasLabel(photo, "subsun"));
  s.belowHorizon = true;
  CHECK(hasLabel(overlay(settings, radians(20), kIndex, s), "subsun"));
}

TEST_CASE("only what the makers make is named, each family in its colour") {
  OverlaySettings s;
  s.halos = true;
  s.gridStep = 0.0;
  s.horizon = s.zenith = false;
  s.makers = {{HaloFamily::plates, prismFaces()}};
  const Overlay plates = overlay(wholeSky(900), radians(25), kIndex, s);
  CHECK(hasLabel(plates, "parhelion"));
  for (const char* text : {"22° halo", "upper tangent arc", "upper suncave Parry arc"}) CHECK(!hasLabel(plates, text));

  // Red outweighs green over plates, and green red over columns, wherever a line covers its pixel.
  s.labels = false;
  const auto redness = [&](HaloFamily family) {
    s.makers = {{family, prismFaces()}};
    const LineArt lines = drawOverlay(wholeSky(900), radians(25), kIndex, s);
    long sum = 0;
    for (std::size_t i = 0; i < lines.rgba.size(); i += 4)
      if (lines.rgba[i + 3] > 200) sum += (lines.rgba[i] > lines.rgba[i + 1]) - (lines.rgba[i] < lines.rgba[i + 1]);
    return sum;
  };
  CHECK(redness(HaloFamily::plates) > 1000);
  CHECK(redness(HaloFamily::columns) < -1000);
}

TEST_CASE("small pictures have a wide grid and no rare halos") {
  OverlaySettings s = everything();
  const Overlay small = overlay(wholeSky(120), radians(20), kIndex, s);
  int drawn = 0, opaque = 0;
  forEachDrawn(small.lines, [&](const Vec2&, int alpha) {
    ++drawn;
    opaque += alpha > 150;
  });
  CHECK(opaque < 120 * 120 / 2);  // there is still a picture to be seen
  s.gridStep = radians(10);
  CHECK(drawnPixels(overlay(wholeSky(120), radians(20), kIndex, s).lines) > drawn);
}
