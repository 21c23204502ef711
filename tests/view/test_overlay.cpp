// SPDX-License-Identifier: Apache-2.0
#include "view/overlay.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "math/rotation.h"
#include "sky/camera.h"
#include "view/overlays.h"

using namespace parhelion;

namespace {

/// Mean distance from `centre`, weighted by alpha, of what is drawn between two radii.
double meanRadius(const LineArt& layer, const Vec2& centre, double from, double to) {
  double sum = 0.0, weight = 0.0;
  forEachDrawn(layer, [&](const Vec2& p, int alpha) {
    const double r = glm::length(p - centre);
    if (r < from || r > to) return;
    sum += alpha * r;
    weight += alpha;
  });
  REQUIRE(weight > 0.0);
  return sum / weight;
}

// Lines are symmetric about their place and their edges smoothed in steps of 1/255: their centroid is good to this.
constexpr double kCentroid = 0.05;  // pixels

}  // namespace

TEST_CASE("the horizon of a level rectilinear camera is the line half way down") {
  OverlaySettings s = bare();
  s.horizon = true;
  const LineArt layer = drawOverlay(cameraOf(Projection::rectilinear, 180, 0, 60, 320, 240), radians(20), kIndex, s);
  for (const int x : {0, 1, 100, 160, 319}) {
    CAPTURE(x);
    double sum = 0.0, weight = 0.0;
    for (int y = 0; y < layer.height; ++y) {
      sum += alphaAt(layer, x, y) * (y + 0.5);
      weight += alphaAt(layer, x, y);
    }
    REQUIRE(weight > 255.0);
    CHECK(std::abs(sum / weight - 120.0) < kCentroid);
  }
}

TEST_CASE("a circle of 22 degrees about the sun has the radius f tan 22 in a rectilinear picture") {
  OverlaySettings s = bare();
  s.circles = {radians(22)};
  const CameraSettings settings = cameraOf(Projection::rectilinear, 0, 20, 70, 601, 601);
  const LineArt layer = drawOverlay(settings, radians(20), kIndex, s);
  const double expected = 300.5 / std::tan(radians(35)) * std::tan(radians(22));
  CHECK(std::abs(meanRadius(layer, Vec2(300.5), 0.5 * expected, 300.0) - expected) < kCentroid);
}

TEST_CASE("lines of the grid lie where the camera puts their altitude") {
  OverlaySettings s = bare();
  s.gridStep = radians(50);
  const CameraSettings settings = wholeSky(600);
  const LineArt layer = drawOverlay(settings, radians(20), kIndex, s);
  // The one altitude above the horizon, 2 sin(20 degrees) focal lengths from the zenith, and the meridians' ends in it.
  const double expected = Camera(settings).focalLength() * 2.0 * std::sin(radians(20));
  double ring = 0.0;
  for (int i = 0; i < 360; ++i) {
    const Vec2 p = Vec2(300.0) + expected * Vec2(std::cos(radians(i + 0.5)), std::sin(radians(i + 0.5)));
    ring += alphaAt(layer, static_cast<int>(p.x), static_cast<int>(p.y)) > 0;
  }
  CHECK(ring == 360.0);
  CHECK(std::abs(meanRadius(layer, Vec2(300.0), expected - 3.0, expected + 3.0) - expected) < kCentroid);
}

TEST_CASE("the outermost line of a picture's sun stands at the sun's place") {
  const CameraSettings settings = cameraOf(Projection::fisheyeStereographic, -30, 40, 120, 400, 300);
  const LineArt layer = drawOverlay(settings, radians(35), kIndex, bare());
  const Vec2 sun = *Camera(settings).project(skyDirection(0.0, radians(35)));
  Vec2 sum(0.0);
  double weight = 0.0;
  forEachDrawn(layer, [&](const Vec2& p, int alpha) {
    sum += static_cast<double>(alpha) * p;
    weight += alpha;
  });
  REQUIRE(weight > 0.0);
  CHECK(glm::length(sum / weight - sun) < kCentroid);
}

TEST_CASE("no line crosses an equirectangular picture from seam to seam") {
  OverlaySettings s = bare();
  s.circles = {radians(22), radians(9)};
  // The sun is on the seam: everything is within 25 degrees of longitude from it.
  const CameraSettings settings = cameraOf(Projection::equirectangular, 180, 0, 360, 720, 360);
  const LineArt layer = drawOverlay(settings, radians(20), kIndex, s);
  int left = 0, right = 0, middle = 0;
  forEachDrawn(layer, [&](const Vec2& p, int) { ++(p.x < 60.0 ? left : p.x > 660.0 ? right : middle); });
  CHECK(middle == 0);
  CHECK(left > 300);
  CHECK(right > 300);
}

TEST_CASE("nothing is drawn of what lies behind a rectilinear camera") {
  OverlaySettings s = bare();
  s.circles = {radians(22), radians(46)};
  CHECK(drawnPixels(drawOverlay(cameraOf(Projection::rectilinear, 180, 0, 80, 200, 200), radians(20), kIndex, s)) == 0);
  CHECK(drawnPixels(drawOverlay(cameraOf(Projection::rectilinear, 0, 20, 110, 200, 200), radians(20), kIndex, s)) >
        1000);
}

TEST_CASE("nothing is drawn outside a fisheye's image circle but half the horizon's width") {
  OverlaySettings s = everything();
  s.labels = false;  // and no legend, which may stand in a corner
  const Overlay o = overlay(wholeSky(500), radians(20), kIndex, s);
  double farthest = 0.0;
  forEachDrawn(o.lines, [&](const Vec2& p, int) { farthest = std::max(farthest, glm::length(p - Vec2(250.0))); });
  CHECK(farthest > 249.0);
  CHECK(farthest < 253.0);
}

TEST_CASE("the same overlay has the same bits twice") {
  const Overlay a = overlay(wholeSky(300), radians(20), kIndex, everything());
  const Overlay b = overlay(wholeSky(300), radians(20), kIndex, everything());
  CHECK(a.lines.rgba == b.lines.rgba);
  CHECK(drawnPixels(a.lines) > 10'000);
}

TEST_CASE("labels stay inside the picture's sky and off each other") {
  const CameraSettings cameras[] = {wholeSky(600), cameraOf(Projection::rectilinear, 10, 25, 75, 700, 450),
                                    cameraOf(Projection::equirectangular, 0, 0, 360, 800, 400),
                                    cameraOf(Projection::fisheyeEquidistant, -60, 30, 140, 300, 500)};
  for (const CameraSettings& settings : cameras)
    for (const double sun : {5.0, 25.0, 60.0}) {
      CAPTURE(static_cast<int>(settings.projection));
      CAPTURE(sun);
      const Camera camera(settings);
      const Overlay o = overlay(settings, radians(sun), kIndex, everything());
      CHECK(o.labels.size() > 10);
      for (std::size_t i = 0; i < o.labels.size(); ++i) {
        const Box& box = o.labels[i].box;
        CAPTURE(o.labels[i].text);
        CHECK(camera.toSky(box.min));
        CHECK(camera.toSky(box.max));
        for (std::size_t k = 0; k < i; ++k) CHECK(!box.overlaps(o.labels[k].box));
      }
    }
}

TEST_CASE("halos, circles, altitudes and azimuths are named") {
  OverlaySettings s = everything();
  const Overlay o = overlay(wholeSky(900), radians(25), kIndex, s);
  for (const char* text :
       {"sun", "zenith", "22° halo", "46° halo", "parhelion", "120° parhelion", "upper tangent arc",
        "circumzenithal arc", "supralateral arc", "parhelic circle", "10°", "30°", "60°", "−80°", "+80°", "180°"}) {
    CAPTURE(text);
    CHECK(hasLabel(o, text));
  }
  CHECK(!hasLabel(o, "circumhorizontal arc"));
}

TEST_CASE("a halo's name stands beside its curve") {
  OverlaySettings s;
  s.halos = true;
  const CameraSettings settings = cameraOf(Projection::rectilinear, 0, 25, 60, 900, 700);
  const Overlay o = overlay(settings, radians(25), kIndex, s);
  const Vec2 sun = *Camera(settings).project(skyDirection(0.0, radians(25)));
  const double radius = Camera(settings).focalLength() * std::tan(radians(21.915));
  for (const PlacedLabel& label : o.labels) {
    if (label.text != "22° halo") continue;
    const Vec2 middle = 0.5 * (label.box.min + label.box.max);
    const double leader = 3.0 * label.box.size().y;
    CHECK(std::abs(glm::length(middle - sun) - radius) < 0.5 * glm::length(label.box.size()) + leader);
  }
  CHECK(hasLabel(o, "22° halo"));
}

TEST_CASE("letters grow with the picture and with the scale") {
  OverlaySettings s = bare();
  s.labels = true;
  const auto height = [&](int size) {
    return overlay(wholeSky(size), radians(20), kIndex, s).labels.at(0).box.size().y;
  };
  const double once = height(900);
  CHECK(height(1800) == doctest::Approx(2.0 * once));
  s.scale = 1.5;
  CHECK(height(900) == doctest::Approx(1.5 * once));
}

TEST_CASE("an overlay of a tiny picture is drawn without labels") {
  for (const Projection projection : {Projection::rectilinear, Projection::equirectangular}) {
    const Overlay o = overlay(cameraOf(projection, 0, 20, 100, 1, 1), radians(20), kIndex, everything());
    CHECK(o.lines.rgba.size() == 4);
    CHECK(o.labels.empty());
  }
}

TEST_CASE("settings of an overlay that make no sense are refused") {
  const auto refuses = [](auto&& spoil) {
    OverlaySettings s;
    spoil(s);
    CHECK_THROWS_AS(overlay(wholeSky(50), radians(20), kIndex, s), std::invalid_argument);
  };
  refuses([](OverlaySettings& s) { s.gridStep = 1e-9; });
  refuses([](OverlaySettings& s) { s.gridStep = -1.0; });
  refuses([](OverlaySettings& s) { s.gridStep = std::numeric_limits<double>::quiet_NaN(); });
  refuses([](OverlaySettings& s) { s.circles = {0.0}; });
  refuses([](OverlaySettings& s) { s.circles = {kPi}; });
  refuses([](OverlaySettings& s) { s.scale = 0.0; });
  refuses([](OverlaySettings& s) { s.scale = 1e9; });
}

TEST_CASE("lines over a dual fisheye break at the seam, and a horizon on it is drawn on both rims") {
  for (const double elevation : {90.0, 0.0, 30.0}) {
    CAPTURE(elevation);
    const CameraSettings camera = cameraOf(Projection::dualFisheyeEqualArea, 0, elevation, 180, 400, 200);
    OverlaySettings settings = bare();
    settings.horizon = true;
    settings.gridStep = radians(15);
    settings.circles = {radians(40), radians(100)};
    int left = 0, right = 0;
    // Nothing but a line's width outside the discs, so none goes from one to the other.
    forEachDrawn(drawOverlay(camera, radians(20), kIndex, settings), [&](const Vec2& at, int) {
      const double fromLeft = glm::length(at - Vec2(100.0)), fromRight = glm::length(at - Vec2(300.0, 100.0));
      CHECK(std::min(fromLeft, fromRight) < 103.0);
      if (std::abs(fromLeft - 100.0) < 2.0) ++left;
      if (std::abs(fromRight - 100.0) < 2.0) ++right;
    });
    if (elevation != 90.0) continue;
    CHECK(left > 600);
    CHECK(right > 600);
  }
}

TEST_CASE("no label lies across the seam of two discs, nor below a horizon that is cut") {
  CameraSettings camera = cameraOf(Projection::dualFisheyeEqualArea, 0, 20, 180, 800, 400);
  for (const Horizon horizon : {Horizon::keep, Horizon::cut}) {
    camera.horizon = horizon;
    const Overlay over = overlay(camera, radians(20), kIndex, everything());
    CHECK(over.labels.size() > 5);
    for (const PlacedLabel& label : over.labels) CHECK((label.box.max.x <= 400.0 || label.box.min.x >= 400.0));
    if (horizon == Horizon::keep) continue;
    CameraSettings whole = camera;
    whole.horizon = Horizon::keep;
    OverlaySettings unnamed = everything();
    unnamed.labels = false;  // and no legend, which may stand there
    forEachDrawn(drawOverlay(camera, radians(20), kIndex, unnamed), [&](const Vec2& at, int) {
      const auto toSky = Camera(whole).toSky(at);
      if (toSky) CHECK(toSky->z > -0.04);  // half a line's width and its shadow
    });
  }
}
