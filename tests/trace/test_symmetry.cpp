// SPDX-License-Identifier: Apache-2.0
// Making use of the sky's symmetry saves rays and changes nothing: pictures against those of plain tracing.
#include <doctest/doctest.h>

#include <cmath>

#include "skies.h"
#include "sky/camera.h"

using namespace parhelion;
using namespace parhelion::test;

namespace {

/// Skies that are their own mirror images, by cameras that are not, and by two that are: with a middle column of pixels
/// and without.
std::vector<View> mirrorViews() {
  PopulationSettings columns = prismPopulation(2.0, AxisOrientation{Normal{0.5 * kPi, radians(1.0)}});
  columns.shape = PrismSettings{UniformRange{1.0, 3.0}};
  std::vector<View> views;
  views.push_back({sunlit({plates()}), lookAt(Projection::fisheyeEqualArea, 30.0, 40.0, 0.0, 180.0)});
  views.push_back({sunlit({parryColumns()}), lookAt(Projection::rectilinear, -20.0, 30.0, 25.0, 100.0)});
  views.push_back({sunlit({lowitzPlates()}), lookAt(Projection::fisheyeStereographic, 30.0, 10.0, 50.0, 140.0)});
  views.push_back(
      {sunlit({plates(), columns, prismPopulation(1.0), pyramids(0.9, 0.2)}, radians(35.0)), wholeSphere()});
  views.push_back({sunlit({columns}), lookAt(Projection::fisheyeEqualArea, 0.0, 90.0, 0.0, 180.0)});
  views.push_back({sunlit({plates()}), lookAt(Projection::rectilinear, 180.0, 20.0, 0.0, 120.0, 25, 20)});
  return views;
}

/// The same picture by a camera on the other side of the sun's vertical, left and right exchanged.
CameraSettings mirrored(CameraSettings camera) {
  camera.azimuth = -camera.azimuth;
  camera.roll = -camera.roll;
  return camera;
}
int mirrored(const Tally& tally, int pixel) {
  const int x = pixel % tally.width();
  return pixel - x + tally.width() - 1 - x;
}

/// Pixels at least so far from the sun's vertical (sine of the angle). From a quarter on, none sees a ray and its
/// mirror image both.
constexpr double kAside = 0.25;
std::vector<int> pixelsOf(const CameraSettings& settings, double aside = 0.0) {
  const Camera camera(settings);
  std::vector<int> pixels;
  for (int pixel = 0; pixel < camera.width() * camera.height(); ++pixel) {
    const auto toSky = camera.toSky(Vec2(pixel % camera.width() + 0.5, pixel / camera.width() + 0.5));
    if (toSky && std::abs(toSky->y) >= aside) pixels.push_back(pixel);
  }
  return pixels;
}

}  // namespace

TEST_CASE("a mirrored picture is the plain one and the mirror image of one by a mirrored camera, of the same rays") {
  for (const View& view : mirrorViews()) {
    const Tally both = traceSky(view.cloud, view.camera, by(Symmetry::mirror, 100'000, 3));
    const Tally plain = traceSky(view.cloud, view.camera, by(Symmetry::none, 100'000, 3));
    const Tally image = traceSky(view.cloud, mirrored(view.camera), by(Symmetry::none, 100'000, 3));
    CHECK(both.info.intercepted.units() == 2 * plain.info.intercepted.units());
    CHECK(both.info.undeviated.units() == 2 * plain.info.undeviated.units());
    for (const int pixel : pixelsOf(view.camera)) {
      const int other = mirrored(both, pixel);
      // Deposits are rounded to whole units of 2^-28, and one that meets its mirror image in a pixel only once.
      const auto hits = static_cast<double>(both.hits(pixel)), slack = 2.0 + hits;
      for (const Tally::Slot slot : {Tally::kY, Tally::kFirstHalf, Tally::kX, Tally::kZ})
        REQUIRE(std::abs(both.raw(pixel, slot) - plain.raw(pixel, slot) - image.raw(other, slot)) < slack);
    }
    // Squares are more where some of a ray's light meets the mirror image of other light of its own: hardly anywhere.
    double squares = 0.0, apart = 0.0;
    for (const int pixel : pixelsOf(view.camera, kAside)) {
      squares += both.squares(pixel);
      apart += plain.squares(pixel) + image.squares(mirrored(both, pixel));
    }
    CHECK(std::abs(squares / apart - 1.0) < 0.005);
  }
}

TEST_CASE("mirrored pictures agree with plain ones of other rays within the errors that the tallies state") {
  for (const View& view : mirrorViews()) {
    const Tally plain = traceSky(view.cloud, view.camera, by(Symmetry::none, 1'000'000, 1));
    const Tally both = traceSky(view.cloud, view.camera, by(Symmetry::mirror, 1'000'000, 2));
    const Disagreement d = comparePictures(plain, both);
    CHECK(d.compared() > 150);
    CHECK(std::abs(d.sigmas()) < kSigmas);
  }
}

TEST_CASE("mirrored pictures have the colours and sums of plain ones, and half their variance") {
  for (const View& view : mirrorViews()) {
    const Replicates plain(view.cloud, view.camera, by(Symmetry::none, 20'000, 100), 48);
    const Replicates both(view.cloud, view.camera, by(Symmetry::mirror, 20'000, 200), 48);
    checkAgree(plain, both);
    // Some 300 pixels in 48 runs know their mean variance to 2 %, to 3 % where few pixels have most of the light.
    const std::vector<int> all = pixelsOf(view.camera), aside = pixelsOf(view.camera, kAside);
    CHECK(std::abs(both.scatterOf(all) / both.statedOf(all) - 1.0) < 0.1);
    CHECK(std::abs(both.statedOf(aside) / plain.statedOf(aside) - 0.5) < 0.01);
  }
}

TEST_CASE("a whole sphere holds all light that is deviated, by any symmetry") {
  const Cloud cloud = sunlit({prismPopulation(2.0), pyramids(0.9, 0.2)});
  LightTotal::Units intercepted = 0;
  for (const Symmetry symmetry : {Symmetry::none, Symmetry::mirror, Symmetry::radial}) {
    const Tally tally = traceSky(cloud, wholeSphere(), by(symmetry, 100'000, 3));
    const double deviated = 1.0 - tally.info.undeviatedFraction();
    // Deposits are rounded to 2^-29; the rings' shares in single pixels are good to 1e-3 of a pixel.
    const double slack = symmetry == Symmetry::radial ? 1e-4 : 1e-9;
    CHECK(std::abs(totalLuminance(tally) / tally.info.interceptedLight() - deviated) < slack);
    if (symmetry == Symmetry::none) intercepted = tally.info.intercepted.units();
    CHECK(tally.info.intercepted.units() == (symmetry == Symmetry::mirror ? 2 : 1) * intercepted);
  }
}

TEST_CASE("a mirrored picture of crystals that are not symmetric is another one") {
  AxisOrientation turned;  // plates that hold still, their edges askew to the sun
  turned.zenith = Normal{0.0, radians(4.0)};
  turned.azimuth = FixedValue{0.0};
  turned.roll = FixedValue{radians(10.0)};
  const Cloud cloud = sunlit({prismPopulation(0.3, turned)});
  CHECK(symmetryOf(cloud, Symmetry::automatic) == Symmetry::none);
  const Disagreement d = comparePictures(traceSky(cloud, wholeSphere(), by(Symmetry::none, 200'000, 1)),
                                         traceSky(cloud, wholeSphere(), by(Symmetry::mirror, 200'000, 2)));
  CHECK(d.sigmas() > 20.0);
}

TEST_CASE("symmetry is chosen by the crystals' orientations unless it is asked for") {
  AxisOrientation pointing;
  pointing.azimuth = FixedValue{radians(40.0)};
  pointing.zenith = FixedValue{radians(60.0)};
  const struct {
    std::vector<PopulationSettings> populations;
    Symmetry automatic;
  } cases[] = {{{prismPopulation(1.0), pyramids(0.9, 0.2)}, Symmetry::radial},
               {{prismPopulation(1.0), plates()}, Symmetry::automatic},  // each by itself
               {{parryColumns(), lowitzPlates()}, Symmetry::mirror},
               {{plates(), prismPopulation(1.0, pointing)}, Symmetry::automatic},
               {{prismPopulation(1.0, pointing)}, Symmetry::none}};
  for (const auto& [populations, automatic] : cases) {
    const Cloud cloud = sunlit(populations);
    CHECK(symmetryOf(cloud, Symmetry::automatic) == automatic);
    for (const Symmetry asked : {Symmetry::none, Symmetry::mirror, Symmetry::radial})
      CHECK(symmetryOf(cloud, asked) == asked);
  }
}

TEST_CASE("the halves of a mirrored picture are as far apart as independent halves are") {
  SampleMean apart;
  for (const View& view : mirrorViews()) {
    const Tally tally = traceSky(view.cloud, view.camera, by(Symmetry::mirror, 500'000, 4));
    for (int pixel = 0; pixel < tally.pixels(); ++pixel) addHalves(tally, pixel, apart);
  }
  CHECK(apart.sigmasFrom(1.0) < kSigmas);
  CHECK(apart.standardError() < 0.05);
}

TEST_CASE("a mirrored picture is the same bits for one, two and seven threads, and from parts") {
  const std::vector<View> views = mirrorViews();
  const auto& [cloud, camera] = views[3];
  const TraceSettings settings = by(Symmetry::mirror, 60'000, 1);
  const Tally one = traceSky(cloud, camera, settings, 0, 1);
  CHECK(one == traceSky(cloud, camera, settings, 0, 2));
  CHECK(one == traceSky(cloud, camera, settings, 0, 7));
  CHECK_FALSE(one == traceSky(cloud, camera, by(Symmetry::mirror, 59'998, 1), 0, 1));
  Tally parts = traceSky(cloud, camera, by(Symmetry::mirror, 25'000, 1));
  parts.merge(traceSky(cloud, camera, settings, 25'000));
  CHECK(parts == one);
}
