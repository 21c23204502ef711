// SPDX-License-Identifier: Apache-2.0
// Pictures of light that a cloud scatters once, twice and more.
#include "render/more_orders.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "math/rotation.h"
#include "optics/spectrum.h"
#include "render/sky_files.h"
#include "render/traced_sky.h"
#include "sky/look_at.h"
#include "sky/radiance.h"
#include "trace/sky_film.h"

using namespace parhelion;
using namespace parhelion::test;

namespace {

const std::string kColumns = "[[population]]\naspect = 1.0\norientation = \"random\"\n";

LoadedScene sceneOf(double sun, double depth, const std::string& orders, const std::string& more = kColumns) {
  return parseScene("[sun]\nelevation = " + std::to_string(sun) +
                        "\nspectrum = 550.0\ndiameter = 0\n[ice]\nindex = 1.31\n" + more +
                        "[cloud]\noptical_depth = " + std::to_string(depth) + "\norders = " + orders +
                        "\n[camera]\nprojection = \"equirectangular\"\nresolution = [180, 90]\n[trace]\nrays = "
                        "\"600k\"\n[recon]\nmethod = \"none\"\n",
                    "orders.toml");
}

/// The light of orders from `first` on through a camera, with its totals; cd/m^2 are kept by `unit`.
struct WalkedTally {
  Tally tally;
  double unit;
};
WalkedTally walk(const LoadedScene& loaded, int first, std::uint64_t walks, const CameraSettings& camera,
                 int threads = 2) {
  const Scene& scene = loaded.scene;
  const SlabLight slab(scene, 0.0);
  const ManyOrders orders({scene.sun, scene.ice, scene.populations, scene.hazes}, scene.cloud->orders, slab.stack(),
                          Engine::automatic);
  TallyInfo info;
  info.camera = camera;
  WalkedTally made{Tally(info, 1), 0.0};
  SkyFilm film({&made.tally}, nullptr);
  OrderDeposits deposits;
  deposits.first = first;
  deposits.scale = 1.0 / orders.scattered();
  TraceControl control;
  control.threads = threads;
  traceOrders(orders, walks, scene.trace, deposits, film, control).light.addTo(made.tally.info);
  made.tally.info.rays = {{0, walks}};
  made.unit = slab.illuminance() * std::sin(scene.sun.elevation) / deposits.scale;
  return made;
}

/// Means over blocks of so many pixels to a side, and their variances.
struct Blocks {
  std::vector<double> mean, variance;

  Blocks(const Image& image, const Camera& camera, int side) {
    const std::vector<float>&light = *image.find("G"), &noise = *image.find(kVarianceChannel);
    for (int y = 0; y + side <= image.height; y += side)
      for (int x = 0; x + side <= image.width; x += side) {
        double sum = 0.0, squares = 0.0, angle = 0.0;
        for (int j = y; j < y + side; ++j)
          for (int i = x; i < x + side; ++i) {
            const auto at = static_cast<std::size_t>(j * image.width + i);
            const double own = camera.solidAngle(i, j);
            sum += own * static_cast<double>(light[at]);
            squares += own * own * static_cast<double>(noise[at]);
            angle += own;
          }
        mean.push_back(sum / angle);
        variance.push_back(squares / (angle * angle));
      }
  }
};

void scaleBy(Image& image, double factor) {
  for (Channel& channel : image.channels)
    for (float& sample : channel.samples)
      sample *= static_cast<float>(channel.name == kVarianceChannel ? factor * factor : factor);
}

double lightOf(const Tally& tally) {
  double sum = 0.0;
  for (int pixel = 0; pixel < tally.pixels(); ++pixel) sum += tally.luminance(pixel);
  return sum / tally.info.interceptedLight();
}
double errorOf(const Tally& tally) {
  double sum = 0.0;
  for (int pixel = 0; pixel < tally.pixels(); ++pixel) sum += std::pow(tally.luminanceError(pixel), 2);
  return std::sqrt(sum) / tally.info.interceptedLight();
}

}  // namespace

TEST_CASE("first order by walks is the closed form times single scattering, in every block within 4 sigma") {
  const std::string hollow =
                        "[[population]]\naspect = 1.0\norientation = \"column\"\ntilt = 5\n"
                        "cavity = { depth = 0.5 }\n",
                    rosettes = "[[population]]\nshape = \"rosette\"\naspect = 1.0\n";
  const struct {
    double depth;
    std::string populations;
  } cases[] = {{0.1, kColumns}, {2.0, kColumns}, {1e-3, hollow + rosettes}, {1.0, hollow + rosettes}};
  for (const auto& [depth, populations] : cases) {
    CAPTURE(depth);
    CAPTURE(populations);
    const LoadedScene loaded = sceneOf(20.0, depth, "1", populations);
    const TracedSky traced = traceSky(loaded, cloudOf(loaded.scene));
    const Camera camera(loaded.scene.camera);
    Image closed = plainRadiance(traced.tally.flattened());
    SlabLight(loaded.scene, traced.tally.info().undeviatedFraction()).apply(closed, camera);
    const WalkedTally walked = walk(loaded, 1, 150'000, loaded.scene.camera);
    Image image = plainRadiance(walked.tally);
    scaleBy(image, walked.unit);
    const Blocks a(closed, camera, 15), b(image, camera, 15);
    for (std::size_t k = 0; k < a.mean.size(); ++k) {
      CAPTURE(k);
      // Undeviated shares are known to half a hundredth of all light.
      const double known = 0.01 * a.mean[k];
      CHECK(std::abs(a.mean[k] - b.mean[k]) < 4.0 * std::sqrt(a.variance[k] + b.variance[k]) + known);
    }
  }
}

TEST_CASE("in a cloud of rosettes the light of all orders is that of each of them together") {
  const std::string rosettes = "[[population]]\nshape = \"rosette\"\naspect = 1.0\n";
  const LoadedScene loaded = sceneOf(20.0, 1.0, "\"all\"", rosettes);
  // The same walks, and what of each is deposited from the second and from the third order on.
  const CameraSettings camera = lookAt(Projection::rectilinear, 40.0, 30.0, 0.0, 20.0, 8, 8);
  const Tally fromSecond = walk(loaded, 2, 40'000, camera).tally, fromThird = walk(loaded, 3, 40'000, camera).tally;
  const LoadedScene twice = sceneOf(20.0, 1.0, "2", rosettes);
  const Tally second = walk(twice, 2, 40'000, camera).tally;
  const double error = std::hypot(errorOf(fromSecond), std::hypot(errorOf(fromThird), errorOf(second)));
  CHECK(std::abs(lightOf(fromSecond) - lightOf(fromThird) - lightOf(second)) < 4.0 * error);
  CHECK(lightOf(fromThird) > 10.0 * errorOf(fromThird));
}

TEST_CASE("44 degree parhelia begin at twice the azimuth of the parhelia") {
  const std::string plates = "[[population]]\naspect = 0.3\norientation = \"plate\"\n";
  const struct { double sun, azimuth; } known[] = {{10.0, 44.97}, {20.0, 49.15}};
  for (const auto& [sun, azimuth] : known) {
    CAPTURE(sun);
    const LoadedScene loaded = sceneOf(sun, 1.0, "2", plates);
    // A strip of 0.05 degrees a pixel, in whose middle row they are.
    const CameraSettings camera = lookAt(Projection::equirectangular, azimuth, sun, 0.0, 4.05, 81, 3);
    const WalkedTally walked = walk(loaded, 2, 400'000, camera);
    std::vector<double> columns(81);
    for (int pixel = 0; pixel < walked.tally.pixels(); ++pixel)
      columns[static_cast<std::size_t>(pixel % 81)] += walked.tally.luminance(pixel);
    // Each of two pixels on either side has the brightness of its own side: the step is within 0.1 degrees.
    const auto mean = [&](int from, int to) {
      double sum = 0.0;
      for (int k = from; k < to; ++k) sum += columns[static_cast<std::size_t>(k)];
      return sum / (to - from);
    };
    const double dim = mean(0, 38), bright = mean(43, 63);
    CHECK(bright > 3.0 * dim);
    for (const int k : {38, 39}) CHECK(columns[static_cast<std::size_t>(k)] < 0.5 * (dim + bright));
    for (const int k : {41, 42}) CHECK(columns[static_cast<std::size_t>(k)] > 0.5 * (dim + bright));
  }
}

TEST_CASE("in the diamond dust of scenes/ light scattered twice makes 44 degree parhelia and a bright anthelion") {
  const LoadedScene loaded =
      loadScene(std::string(PARHELION_SOURCE_DIR) + "/scenes/diamond-dust.toml",
                std::vector<std::string>{"sun.spectrum=550", "sun.diameter=0", "cloud.orders=2", "trace.rays=600000"});
  const auto seen = [&](double azimuth) {  // 2 degrees of the parhelic circle, on either side
    const CameraSettings camera = lookAt(Projection::rectilinear, azimuth, 10.0, 0.0, 2.0, 1, 1);
    return lightOf(walk(loaded, 2, 100'000, camera).tally);
  };
  CHECK(seen(46.5) > 2.5 * seen(43.0));
  CHECK(seen(178.0) > 1.25 * seen(168.0));
}

TEST_CASE("sun and observer can change places in a cloud of random crystals") {
  const auto seen = [](double sun, double view) {
    const LoadedScene loaded = sceneOf(sun, 1.0, "\"all\"");
    const WalkedTally walked = walk(loaded, 2, 150'000, lookAt(Projection::rectilinear, 60.0, view, 0.0, 10.0, 8, 8));
    return std::pair(lightOf(walked.tally), errorOf(walked.tally));
  };
  const auto scaled = [](double sun, std::pair<double, double> light) {
    // Walks begin with the light that is scattered: in units of that on a surface which faces the sun.
    const LoadedScene loaded = sceneOf(sun, 1.0, "2");
    const Scene& scene = loaded.scene;
    const SlabLight slab(scene, 0.0);
    const ManyOrders orders({scene.sun, scene.ice, scene.populations, {}}, scene.cloud->orders, slab.stack(),
                            Engine::automatic);
    return std::pair(light.first * orders.scattered(), light.second * orders.scattered());
  };
  for (const double side : {1.0, -1.0}) {
    CAPTURE(side);
    const auto a = scaled(20.0, seen(20.0, side * 50.0)), b = scaled(50.0, seen(50.0, side * 20.0));
    CHECK(std::abs(a.first - b.first) < 4.0 * std::hypot(a.second, b.second));
    CHECK(a.second < 0.05 * a.first);
  }
}

TEST_CASE("walks have the same bits for any number of threads") {
  const LoadedScene loaded = sceneOf(20.0, 1.0, "\"all\"");
  const WalkedTally one = walk(loaded, 2, 40'000, loaded.scene.camera, 1),
                    three = walk(loaded, 2, 40'000, loaded.scene.camera, 3);
  CHECK(one.tally == three.tally);
}

TEST_CASE("layers by order add up to the picture, and a thin cloud has next to no light of second order") {
  const std::string layers = "[[layer]]\nname = \"second\"\norder = 2\n[[layer]]\nname = \"once\"\norder = 1\n";
  const LoadedScene loaded = sceneOf(20.0, 0.5, "3", kColumns + layers);
  const SlabLight slab(loaded.scene, 0.24);
  const auto more = moreOrders(loaded, 0, slab, {}, 2);
  REQUIRE(more);
  const auto sumOf = [&](const char* channel) {
    double sum = 0.0;
    for (const float sample : *more->image.find(channel)) sum += static_cast<double>(sample);
    return sum;
  };
  CHECK(sumOf("once.G") == 0.0);
  CHECK(sumOf("second.G") > sumOf("rest.G"));
  CHECK(sumOf("rest.G") > 0.0);
  CHECK(sumOf("second.G") + sumOf("rest.G") == doctest::Approx(sumOf("G")).epsilon(1e-5));
  const LoadedScene thin = sceneOf(20.0, 1e-4, "\"all\"");
  const OrderLedger energy = moreOrders(thin, 0, SlabLight(thin.scene, 0.24), {}, 2)->report.energy;
  const auto outOf = [&](std::size_t place) { return energy.above[place].value() + energy.below[place].value(); };
  CHECK(outOf(1) < 1e-2 * outOf(0));
  CHECK_FALSE(moreOrders(sceneOf(20.0, 0.5, "1"), 0, slab, {}, 2));
  CHECK_FALSE(moreOrders(sceneOf(-1.0, 0.5, "2"), 0, slab, {}, 2));
}
