// SPDX-License-Identifier: Apache-2.0
// Skies of crystals in random orientation from light counted by its angle from the sun alone, against plain tracing.
#include <doctest/doctest.h>

#include <cmath>

#include "skies.h"
#include "sky/camera.h"

using namespace parhelion;
using namespace parhelion::test;

namespace {

std::vector<View> radialViews() {
  std::vector<View> views;
  views.push_back({simpleCloud({prismPopulation(1.0), pyramids(0.6, 0.6)}),
                   lookAt(Projection::fisheyeEqualArea, 30.0, 60.0, 15.0, 180.0)});
  views.push_back(
      {sunlit({prismPopulation(0.3), pyramids(0.9, 0.2)}), lookAt(Projection::rectilinear, 15.0, 25.0, 20.0, 100.0)});
  views.push_back({sunlit({prismPopulation(2.0)}), wholeSphere()});
  return views;
}

}  // namespace

TEST_CASE("radial pictures agree with plain ones of other rays within the errors that the tallies state") {
  for (const View& view : radialViews()) {
    // Pixels share rings, and so their noise: of more rays, it does not count.
    const Tally plain = traceSky(view.cloud, view.camera, by(Symmetry::none, 1'000'000, 1));
    const Tally rings = traceSky(view.cloud, view.camera, by(Symmetry::radial, 4'000'000, 2));
    const Disagreement d = comparePictures(plain, rings);
    CHECK(d.compared() > 150);
    CHECK(std::abs(d.sigmas()) < kSigmas);
  }
}

TEST_CASE("radial pictures have the colours and sums of plain ones") {
  for (const View& view : radialViews())
    checkAgree(Replicates(view.cloud, view.camera, by(Symmetry::none, 10'000, 100), 48),
               Replicates(view.cloud, view.camera, by(Symmetry::radial, 40'000, 200), 48));
}

TEST_CASE("radial pictures have two hundred times less variance than plain ones where a pixel is that part of a ring") {
  // One wavelength: where the two of a bundle fall into two rings of a pixel, the stated variance falls short.
  const Cloud cloud = simpleCloud({prismPopulation(1.0)});
  const CameraSettings settings = lookAt(Projection::fisheyeEqualArea, 30.0, 60.0, 15.0, 180.0, 192, 192);
  const Camera camera(settings);
  std::vector<int> halo;  // 23 to 45 degrees from the sun, where a ring is 140 to 270 pixels long
  for (int pixel = 0; pixel < camera.width() * camera.height(); ++pixel) {
    const auto toSky = camera.toSky(Vec2(pixel % camera.width() + 0.5, pixel / camera.width() + 0.5));
    if (!toSky) continue;
    const double angle = angleBetween(*toSky, cloud.sun().toCentre());
    if (angle > radians(23.0) && angle < radians(45.0)) halo.push_back(pixel);
  }
  const Replicates plain(cloud, settings, by(Symmetry::none, 20'000, 100), 16);
  const Replicates rings(cloud, settings, by(Symmetry::radial, 20'000, 200), 64);
  const double gain = plain.scatterOf(halo) / rings.scatterOf(halo);
  MESSAGE("variance of plain over that of radial pictures: " << gain);
  CHECK(gain > 200.0);
  // The band has some 25 pixels across, each of its own noise: in 64 runs the mean variance is known to 4 %.
  CHECK(std::abs(rings.scatterOf(halo) / rings.statedOf(halo) - 1.0) < 0.16);
}

TEST_CASE("the halves of a radial picture are as far apart as independent halves are") {
  const std::vector<View> views = radialViews();
  SampleMean apart;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const Tally tally = traceSky(views[0].cloud, views[0].camera, by(Symmetry::radial, 20'000, seed));
    // Every other pixel of a row has rings of its own.
    for (int x = 0; x < tally.width(); x += 2) addHalves(tally, tally.width() * (tally.height() / 2) + x, apart);
  }
  CHECK(apart.sigmasFrom(1.0) < kSigmas);
  CHECK(apart.standardError() < 0.1);
}

TEST_CASE("a radial picture is the same bits for one, two and seven threads, and nearly so from parts") {
  const std::vector<View> views = radialViews();
  const auto& [cloud, camera] = views[1];
  const TraceSettings settings = by(Symmetry::radial, 60'000, 1);
  const Tally one = traceSky(cloud, camera, settings, 0, 1);
  CHECK(one == traceSky(cloud, camera, settings, 0, 2));
  CHECK(one == traceSky(cloud, camera, settings, 0, 7));
  CHECK_FALSE(one == traceSky(cloud, camera, by(Symmetry::radial, 59'998, 1), 0, 1));

  Tally parts = traceSky(cloud, camera, by(Symmetry::radial, 25'000, 1));
  parts.merge(traceSky(cloud, camera, settings, 25'000));
  CHECK(parts.info == one.info);
  // Sums are rounded to whole units where rings are spread over pixels.
  for (int pixel = 0; pixel < one.pixels(); ++pixel)
    for (const Tally::Slot slot : {Tally::kY, Tally::kFirstHalf, Tally::kSquares, Tally::kX, Tally::kZ})
      REQUIRE(std::abs(parts.raw(pixel, slot) - one.raw(pixel, slot)) <= 1);
}
