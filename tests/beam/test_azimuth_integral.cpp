// SPDX-License-Identifier: Apache-2.0
// Crystals of all azimuths that stand alike otherwise: the sun's disc in slices, and prisms whose sides differ.
#include <cmath>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "beam/azimuth_integral.h"
#include "beam/sun_slices.h"
#include "crystal/orientation.h"
#include "optics/sun.h"
#include "sky/camera.h"

using namespace parhelion;

namespace {

SunFace faceOf(const Sun& sun) {
  return {sun.toCentre(), 0.5 * sun.diameter(), [&sun](double angle) { return sun.radiance(angle); }};
}

}  // namespace

TEST_CASE("slices of the sun's disc have its brightness: all of it, its middle and its width") {
  // The last one has the zenith in its disc.
  for (const double elevation : {0.0, 20.0, 80.0, 89.7}) {
    CAPTURE(elevation);
    SunSettings settings;
    settings.elevation = radians(elevation);
    settings.diameter = radians(1.0);
    const Sun sun(settings);
    const SunSlices slices(faceOf(sun), 64, 64);
    Vec3 middle(0.0);
    double all = 0.0, square = 0.0;
    for (const SunSlices::Line& line : slices.lines())
      for (std::size_t k = 0; k < line.points.size(); ++k) {
        const double weight = line.share * line.points[k].weight / 64.0, up = slices.elevations()[k];
        const Vec3 point(std::cos(up) * std::cos(line.points[k].azimuth),
                         std::cos(up) * std::sin(line.points[k].azimuth), std::sin(up));
        all += weight;
        middle += weight * point;
        square += weight * std::pow(glm::length(point - sun.toCentre()), 2.0);
      }
    CHECK(all == doctest::Approx(1.0).epsilon(1e-12));
    CHECK(glm::length(middle - sun.toCentre()) < 2e-3 * radians(0.5));
    double mean = 0.0, norm = 0.0;
    for (int k = 0; k < 4000; ++k) {
      const double angle = radians(0.5) * (k + 0.5) / 4000.0, light = angle * sun.radiance(angle);
      norm += light;
      mean += light * angle * angle;
    }
    CHECK(square == doctest::Approx(mean / norm).epsilon(5e-3));
  }
}

TEST_CASE("half as many lines across the sun make its light, too") {
  SunSettings settings;
  settings.elevation = radians(35.0);
  const Sun sun(settings);
  const SunSlices slices(faceOf(sun), 8, 8);
  double share = 0.0, coarse = 0.0;
  for (const SunSlices::Line& line : slices.lines()) {
    share += line.share;
    coarse += line.coarse;
  }
  CHECK(share == doctest::Approx(1.0));
  CHECK(coarse == doctest::Approx(1.0));
  CHECK(slices.lines()[0].coarse == 0.0);
}

TEST_CASE("all light of prisms whose sides differ comes to the sky, goes straight on or is cut off") {
  CameraSettings settings;
  settings.projection = Projection::equirectangular;
  settings.width = 90;
  settings.height = 45;
  settings.fieldOfView = 2.0 * kPi;
  settings.elevation = 0.0;
  const Camera camera(settings);
  for (const double roll : {0.0, 17.0}) {
    CAPTURE(roll);
    AxisScene scene;
    scene.section = PrismSection({0.9, 0.7, 0.8, 1.1, 0.75, 0.95});
    scene.prisms = {{1.7, 1.0}};
    scene.indices = {1.31};
    scene.lines = {{1.31, {1.0, 1.0, 1.0}}};
    scene.light = [&](double) { return scene.lines[0]; };
    scene.sun.toCentre = Vec3(std::cos(0.4), 0.0, std::sin(0.4));
    scene.rest =
        standingOf(AxisOrientation{FixedValue{radians(75.0)}, AxisOrientation{}.azimuth, FixedValue{radians(roll)}});
    scene.isMirrored = false;
    SkyAccuracy accuracy;
    accuracy.error = 0.1;
    const SkyIntegral sky = integrateAzimuths(scene, accuracy, camera);
    double light = sky.totals.undeviated + sky.totals.cutOff;
    for (const auto& xyz : sky.xyz) light += static_cast<double>(xyz[1]);
    CHECK(light == doctest::Approx(sky.totals.intercepted).epsilon(2e-3));
    CHECK(sky.totals.cutOff < 1e-5 * sky.totals.intercepted);
  }
}

TEST_CASE("a picture that is folded has the light of all azimuths from half of them") {
  CameraSettings settings;
  settings.projection = Projection::fisheyeEqualArea;
  settings.width = settings.height = 64;
  settings.fieldOfView = kPi;
  settings.elevation = 0.5 * kPi;
  const Camera camera(settings);
  AxisScene scene;
  scene.prisms = {{4.0, 1.0}};
  scene.indices = {1.31};
  scene.lines = {{1.31, {1.0, 1.0, 1.0}}};
  scene.light = [&](double) { return scene.lines[0]; };
  SunSettings sunSettings;
  sunSettings.elevation = radians(20.0);
  const Sun sun(sunSettings);
  scene.sun = faceOf(sun);
  scene.rest =
      standingOf(AxisOrientation{FixedValue{radians(90.0)}, AxisOrientation{}.azimuth, FixedValue{radians(0.0)}});
  SkyAccuracy accuracy;
  accuracy.error = 0.05;
  const SkyIntegral whole = integrateAzimuths(scene, accuracy, camera);
  accuracy.folds = true;
  const SkyIntegral folded = integrateAzimuths(scene, accuracy, camera);
  CHECK(folded.directions < 0.6 * whole.directions);
  CHECK(folded.totals.intercepted == doctest::Approx(whole.totals.intercepted).epsilon(1e-3));
  double light = 0.0, off = 0.0;
  for (std::size_t i = 0; i < whole.xyz.size(); ++i) {
    light += static_cast<double>(whole.xyz[i][1]);
    off += std::abs(static_cast<double>(folded.xyz[i][1] - whole.xyz[i][1]));
  }
  CHECK(off < 0.01 * light);
}
