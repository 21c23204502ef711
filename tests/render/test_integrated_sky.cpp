// SPDX-License-Identifier: Apache-2.0
// Skies without rays, held against rays.
#include "render/integrated_sky.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

#include <doctest/doctest.h>

#include "parallel/threads.h"
#include "render/traced_sky.h"
#include "scenes.h"
#include "sky/camera.h"
#include "sky/radiance.h"
#include "statistics.h"

using namespace parhelion;
using namespace parhelion::test;

namespace {

/// Bins of 5 degrees over the whole sphere.
const std::string kBins =
    "[camera]\nprojection = \"equirectangular\"\nfov_horizontal = 360.0\nresolution = [72, 36]\n"
    "elevation = 0.0\n[recon]\nmethod = \"none\"\n";

/// A scene of one population of prisms, drawn at random.
std::string drawnScene(std::mt19937_64& random) {
  const auto between = [&](double a, double b) { return a + (b - a) * static_cast<double>(random() >> 11) * 0x1p-53; };
  const int kind = static_cast<int>(random() % 4);
  char text[600];
  const double aspect = std::exp(between(std::log(0.1), std::log(4.0))), sun = between(0.0, 75.0);
  const char* const spectra[] = {"550.0", "[500.0, 650.0]", "\"sun\""};
  const char* const discs[] = {"0.0", "0.533", "2.0"};
  const char* const orientations[] = {"random", "plate", "column", "column"};
  const char *const spectrum = spectra[random() % 3], *const disc = discs[random() % 3];
  const double tilt = kind == 3 && between(0.0, 1.0) < 0.5 ? 0.0 : between(0.5, 12.0);
  std::snprintf(text, sizeof text,
                "[sun]\nelevation = %.3f\ndiameter = %s\nspectrum = %s\nvisible = false\n[[population]]\n"
                "shape = \"prism\"\naspect = %.4f\norientation = \"%s\"\n",
                sun, disc, spectrum, aspect, orientations[kind]);
  std::string scene = text;
  if (kind > 0) {
    std::snprintf(text, sizeof text, "tilt = %.3f\n", tilt);
    scene += text;
  }
  return scene;
}

/// Crystals that stand alike but for their azimuths, drawn at random: every other one a Parry column.
std::string standingScene(std::mt19937_64& random, int number) {
  const auto between = [&](double a, double b) { return a + (b - a) * static_cast<double>(random() >> 11) * 0x1p-53; };
  const double aspect = std::exp(between(std::log(0.3), std::log(4.0))), sun = between(2.0, 75.0);
  const char* const spectra[] = {"550.0", "\"sun\"", "[500.0, 650.0]"};
  const char* const discs[] = {"0.0", "0.533", "2.0"};
  const char *const spectrum = spectra[number % 3], *const disc = discs[(number + number / 3) % 3];
  char stands[100] = "\"parry\"";
  if (number % 2 == 1)
    std::snprintf(stands, sizeof stands, "{ zenith = %.3f, roll = %.3f }", between(0.0, 180.0), between(0.0, 360.0));
  char text[600];
  std::snprintf(text, sizeof text,
                "[sun]\nelevation = %.3f\ndiameter = %s\nspectrum = %s\nvisible = false\n[[population]]\n"
                "shape = \"prism\"\naspect = %.4f\norientation = %s\n",
                sun, disc, spectrum, aspect, stands);
  return text;
}

struct Agreement {
  int bins = 0, beyond = 0;  // those with light, and those that differ by more than 4.5 sigma
};

std::vector<double> luminanceOf(const Image& image) {
  const auto &r = *image.find("R"), &g = *image.find("G"), &b = *image.find("B");
  std::vector<double> luminance;
  for (std::size_t i = 0; i < r.size(); ++i)
    luminance.push_back(0.2126 * static_cast<double>(r[i]) + 0.7152 * static_cast<double>(g[i]) +
                        0.0722 * static_cast<double>(b[i]));
  return luminance;
}

Agreement compare(const std::string& scene, double error) {
  const LoadedScene loaded = parseScene(scene + kBins + "[trace]\nrays = \"4M\"\nseed = 5\n", "drawn.toml");
  REQUIRE(objectionToIntegratedSky(loaded.scene).empty());
  const IntegratedSky integral = integrateSky(loaded, error);
  const Image rays = plainRadiance(traceSky(loaded, cloudByLight(loaded.scene)).tally.flattened());
  const std::vector<double> a = luminanceOf(integral.image), b = luminanceOf(rays);
  const auto &va = *integral.image.find(kVarianceChannel), &vb = *rays.find(kVarianceChannel);
  Agreement result;
  for (std::size_t i = 0; i < a.size(); ++i) {
    // Few hits of unequal light are not spread as sigmas say.
    if (static_cast<double>(vb[i]) > std::pow(0.05 * b[i], 2.0)) continue;
    const double sigma = std::sqrt(static_cast<double>(va[i]) + static_cast<double>(vb[i]));
    const double apart = std::abs(a[i] - b[i]) / sigma;
    ++result.bins;
    result.beyond += apart > kSigmas;
  }
  return result;
}

}  // namespace

namespace {

/// Ten of the scenes that a seed draws.
void holdAgainstRays(int first) {
  std::mt19937_64 random(20261129);
  for (int k = 0; k < first + 10; ++k) {
    const std::string scene = drawnScene(random);
    if (k < first) continue;
    CAPTURE(scene);
    const Agreement agreement = compare(scene, 0.05);
    CHECK(agreement.bins > 20);
    CHECK(agreement.beyond == 0);
  }
}

}  // namespace

TEST_CASE("rays agree with integrated skies of prisms drawn at random: first ten") { holdAgainstRays(0); }
TEST_CASE("rays agree with integrated skies of prisms drawn at random: second ten") { holdAgainstRays(10); }
TEST_CASE("rays agree with integrated skies of prisms drawn at random: third ten") { holdAgainstRays(20); }
TEST_CASE("rays agree with integrated skies of prisms drawn at random: fourth ten") { holdAgainstRays(30); }
TEST_CASE("rays agree with integrated skies of prisms drawn at random: fifth ten") { holdAgainstRays(40); }

TEST_CASE("rays agree with integrated skies of Parry columns and others of one tilt and roll, drawn at random") {
  // Each spectrum comes with each disc.
  std::mt19937_64 random(20261129);
  for (int k = 0; k < 9; ++k) {
    const std::string scene = standingScene(random, k);
    CAPTURE(scene);
    const Agreement agreement = compare(scene, 0.1);
    CHECK(agreement.bins > 20);
    CHECK(agreement.beyond == 0);
  }
}

TEST_CASE("plates of one roll at rest are plates of all rolls: their azimuths are free") {
  const std::string sun = "[sun]\nelevation = 31.0\ndiameter = 0.0\nspectrum = 550.0\n";
  const auto plates = [&](const std::string& orientation) {
    return integrateSky(
        parseScene(sun + "[[population]]\naspect = 0.4\norientation = " + orientation + "\n" + kBins, "p.toml"), 0.01);
  };
  const IntegratedSky one = plates("{ zenith = 0.0, roll = 10.0 }"), all = plates("\"plate\"");
  const std::vector<double> a = luminanceOf(one.image), b = luminanceOf(all.image);
  CHECK(one.info.undeviatedFraction() == doctest::Approx(all.info.undeviatedFraction()).epsilon(1e-4));
  // Light above and below the sun is on the border between the middle pixels: left and right are taken together.
  double apart = 0.0, light = 0.0;
  for (std::size_t y = 0; y < 36; ++y)
    for (std::size_t x = 0; x < 36; ++x) {
      const std::size_t left = 72 * y + x, right = 72 * y + 71 - x;
      apart += std::abs(a[left] + a[right] - b[left] - b[right]);
      light += b[left] + b[right];
    }
  CHECK(apart < 0.02 * light);
}

namespace {

const std::string kColumns =
    "[sun]\nelevation = 45.0\ndiameter = 0.0\nspectrum = 550.0\n[[population]]\n"
    "aspect = 1.3\norientation = \"column\"\ntilt = 0.0\n";
const std::string kPlates =
    "[sun]\nelevation = 32.0\ndiameter = 0.0\nspectrum = 550.0\n[[population]]\n"
    "aspect = 0.25\norientation = \"plate\"\ntilt = 0.7\n";
const std::string kTiltedColumns =
    "[sun]\nelevation = 12.0\nspectrum = 550.0\n[[population]]\n"
    "aspect = 2.0\norientation = \"column\"\ntilt = 0.5\n";
const std::string kParry =
    "[sun]\nelevation = 21.3\ndiameter = 0.0\nspectrum = 550.0\n[[population]]\n"
    "aspect = 2.0\norientation = \"parry\"\n";
const std::string kParryAndDisc =
    "[sun]\nelevation = 38.0\nspectrum = 550.0\n[[population]]\n"
    "aspect = 1.0\norientation = \"parry\"\n";
const std::string kParryInColours =
    "[sun]\nelevation = 9.0\ndiameter = 0.0\n[[population]]\n"
    "aspect = 0.7\norientation = \"parry\"\n";
const std::string kFisheye = "[camera]\nprojection = \"fisheye-equal-area\"\nresolution = [96, 96]\n";

IntegratedSky skyOf(const std::string& scene, double error) { return integrateSky(parseScene(scene, "s.toml"), error); }

/// Shares of the pixels in which two pictures differ by at most 1, 2 and 3 of the first one's stated errors.
std::array<double, 3> within(const Image& a, const Image& b) {
  const std::vector<double> la = luminanceOf(a), lb = luminanceOf(b);
  const auto& variance = *a.find(kVarianceChannel);
  std::array<double, 3> counts{};
  double pixels = 0.0;
  for (std::size_t i = 0; i < la.size(); ++i) {
    if (la[i] <= 0.0 && lb[i] <= 0.0) continue;
    pixels += 1.0;
    const double apart = std::abs(la[i] - lb[i]);
    for (std::size_t k = 0; k < 3; ++k)
      counts[k] += apart <= static_cast<double>(k + 1) * std::sqrt(static_cast<double>(variance[i]));
  }
  for (double& count : counts) count /= pixels;
  return counts;
}

}  // namespace

TEST_CASE("the errors that integrated skies state are those that they have against finer ones") {
  for (const std::string& scene : {kColumns, kPlates, kTiltedColumns}) {
    CAPTURE(scene);
    const auto shares = within(skyOf(scene + kFisheye, 0.1).image, skyOf(scene + kFisheye, 0.004).image);
    CHECK(shares[0] >= 0.6);
    CHECK(shares[1] >= 0.9);
    CHECK(shares[2] >= 0.98);
  }
}

TEST_CASE("the errors of crystals at rest under the sun's disc are those that are stated") {
  // Pixels of 0.16 degrees about a tangent arc: the first mesh against one that is finer.
  const std::string scene =
      "[sun]\nelevation = 45.0\nspectrum = 550.0\n[[population]]\naspect = 3.0\norientation = \"column\"\ntilt = 0.0\n"
      "[camera]\nelevation = 67.0\nfov_horizontal = 15.0\nresolution = [96, 96]\n";
  const auto shares = within(skyOf(scene, 1.0).image, skyOf(scene, 0.001).image);
  CHECK(shares[0] >= 0.6);
  CHECK(shares[1] >= 0.9);
  CHECK(shares[2] >= 0.98);
}

TEST_CASE("the errors that integrated skies of crystals of one tilt and roll state are those that they have") {
  // The first mesh against one that is three times as fine, at least.
  for (const auto& [scene, fine] : {std::pair{kParry, 0.0012}, {kParryAndDisc, 0.008}, {kParryInColours, 0.006}}) {
    CAPTURE(scene);
    const auto shares = within(skyOf(scene + kFisheye, 0.1).image, skyOf(scene + kFisheye, fine).image);
    CHECK(shares[0] >= 0.6);
    CHECK(shares[1] >= 0.9);
    CHECK(shares[2] >= 0.98);
  }
}

TEST_CASE("beside the sharp edges of coloured arcs an integrated sky has no less than no light") {
  const LoadedScene loaded = parseScene(
      "[sun]\nelevation = 10.0\n[[population]]\naspect = 2.0\norientation = \"column\"\ntilt = 0.3\n[camera]\n"
      "projection = \"rectilinear\"\nelevation = 25.0\nfov_horizontal = 60.0\nresolution = [160, 160]\n",
      "arcs.toml");
  const IntegratedSky sky = integrateSky(loaded, 0.1);
  const std::vector<double> luminance = luminanceOf(sky.image);
  const auto dark = [](double light) { return light < 0.0; };
  CHECK(std::ranges::count_if(luminance, dark) == 0);
}

TEST_CASE("dark pixels beside bright edges stay dark") {
  const std::string camera = "[camera]\nprojection = \"fisheye-equal-area\"\nresolution = [512, 512]\n";
  const std::vector<double> a = luminanceOf(skyOf(kPlates + camera, 0.02).image),
                            b = luminanceOf(skyOf(kPlates + camera, 0.01).image);
  double mean = 0.0, apart = 0.0, pixels = 0.0;
  for (const double light : b) {
    mean += light;
    pixels += light > 0.0;
  }
  mean /= pixels;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i] <= 0.0 && b[i] <= 0.0) continue;
    apart += std::pow(a[i] - b[i], 2.0) / (b[i] * b[i] + 0.01 * mean * mean) / pixels;
  }
  CHECK(apart < 2e-3);
}

TEST_CASE("the rim of a picture, whose pixels see little of the sky, has the light that rays find there") {
  const LoadedScene loaded = parseScene(
      "[sun]\nelevation = 1.0\nvisible = false\n[[population]]\naspect = 0.2\norientation = \"plate\"\ntilt = 0.7\n"
      "[camera]\nprojection = \"fisheye-equal-area\"\nfov_horizontal = 180.0\nresolution = [256, 256]\n"
      "[recon]\nmethod = \"none\"\n[trace]\nrays = \"1M\"\n",
      "rim.toml");
  const IntegratedSky sky = integrateSky(loaded, 0.1);
  CHECK(sky.error < 0.1);
  const std::vector<double> integral = luminanceOf(sky.image),
                            rays = luminanceOf(
                                plainRadiance(traceSky(loaded, cloudByLight(loaded.scene)).tally.flattened()));
  double a = 0.0, b = 0.0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const double x = static_cast<double>(i % 256) - 127.5, y = static_cast<double>(i / 256) - 127.5;
    if (std::hypot(x, y) < 127.0) continue;
    a += integral[i];
    b += rays[i];
  }
  // Parhelia on the horizon, by a hundred thousand rays.
  CHECK(a == doctest::Approx(b).epsilon(0.05));
}

TEST_CASE("an integrated sky is the same to the bit for any number of threads") {
  const std::string display =
      "[sun]\nspectrum = [500.0, 600.0]\n[[population]]\nname = \"a\"\naspect = 0.3\n"
      "orientation = \"plate\"\ntilt = 1.0\n[[population]]\nname = \"b\"\naspect = 1.0\n"
      "orientation = \"random\"\n[[population]]\nname = \"c\"\naspect = 1.0\norientation = \"parry\"\n"
      "[camera]\nresolution = [40, 40]\n";
  const Image one = withThreads(1, [&] { return skyOf(display, 0.3).image; }),
              three = withThreads(3, [&] { return skyOf(display, 0.3).image; });
  REQUIRE(one.channels.size() == three.channels.size());
  for (std::size_t k = 0; k < one.channels.size(); ++k) CHECK(one.channels[k].samples == three.channels[k].samples);
}

TEST_CASE("what pictures leave to the next changes no bit of them, and spares tracing") {
  const auto frame = [](double sun, double tilt) {
    return "[sun]\nspectrum = 550.0\nelevation = " + std::to_string(sun) +
           "\n[[population]]\naspect = 0.3\norientation = \"plate\"\ntilt = " + std::to_string(tilt) +
           "\n[[population]]\naspect = 1.0\norientation = \"random\"\n[camera]\nresolution = [24, 24]\n";
  };
  const std::pair<double, double> frames[] = {{20.0, 1.0}, {23.0, 1.0}, {23.0, 3.0}, {60.0, 1.0}};
  // Room for all, for some bands, and for none.
  for (const std::uint64_t room : {1'000'000'000, 3'000'000, 0}) {
    LightStore store{BandStore(room), {}};
    long directions = 0, alone = 0;
    for (const auto& [sun, tilt] : frames) {
      CAPTURE(room);
      CAPTURE(sun);
      const LoadedScene loaded = parseScene(frame(sun, tilt), "f.toml");
      const IntegratedSky one = integrateSky(loaded, 0.5), next = integrateSky(loaded, 0.5, &store);
      directions += next.directions;
      alone += one.directions;
      CHECK(one.error == next.error);
      CHECK(one.info.undeviatedFraction() == next.info.undeviatedFraction());
      for (std::size_t k = 0; k < one.image.channels.size(); ++k)
        CHECK(one.image.channels[k].samples == next.image.channels[k].samples);
    }
    // Rings are traced once, and plates for places of the sun that others had.
    CHECK(directions < (room > 0 ? 0.8 : 1.0) * static_cast<double>(alone));
  }
}

TEST_CASE("populations as layers add up to an integrated sky") {
  const IntegratedSky sky = skyOf(
      "layers = \"populations\"\n[sun]\nspectrum = 550.0\ndiameter = 0.0\n"
      "[[population]]\nname = \"a\"\naspect = 0.3\norientation = \"plate\"\n"
      "tilt = 1.0\n[[population]]\nname = \"b\"\naspect = 1.0\n"
      "orientation = \"random\"\n[camera]\nresolution = [40, 40]\n",
      0.1);
  const auto &all = *sky.image.find("G"), &a = *sky.image.find("a.G"), &b = *sky.image.find("b.G"),
             &rest = *sky.image.find("rest.G");
  for (std::size_t i = 0; i < all.size(); ++i) {
    CHECK(rest[i] == 0.0F);
    CHECK(static_cast<double>(a[i]) + static_cast<double>(b[i]) ==
          doctest::Approx(static_cast<double>(all[i])).epsilon(1e-5));
  }
}

TEST_CASE("light that rays find from an integrated sky's ledger") {
  // What goes straight on, and all light: of plates under a high sun, and of Parry columns.
  for (const std::string& scene : {kPlates, kParry, kParryAndDisc}) {
    CAPTURE(scene);
    const LoadedScene loaded = parseScene(scene + kBins + "[trace]\nrays = \"300k\"\n", "p.toml");
    const IntegratedSky sky = integrateSky(loaded, 0.1);
    const TallyInfo traced = traceSky(loaded, cloudByLight(loaded.scene)).tally.info();
    CHECK(sky.info.undeviatedFraction() == doctest::Approx(traced.undeviatedFraction()).epsilon(0.01));
    CHECK(sky.cutOff < 1e-6);
    const std::vector<double> solidAngles = Camera(loaded.scene.camera).solidAngles();
    const auto& light = *sky.image.find("G");
    double sum = sky.info.undeviatedFraction() + sky.cutOff;
    for (std::size_t i = 0; i < light.size(); ++i) sum += solidAngles[i] * static_cast<double>(light[i]);
    CHECK(sum == doctest::Approx(1.0).epsilon(2e-3));
  }
}

TEST_CASE("the upper suncave Parry arc is highest where closed forms have it") {
  // Straight above a point sun at h: 30 + asin(n sin(60 - asin(cos h / n))) degrees.
  constexpr double kIndex = 1.31;
  for (const double sun : {1.0, 20.0, 40.0}) {
    CAPTURE(sun);
    const double inside = radians(60.0) - std::asin(std::cos(radians(sun)) / kIndex);
    const double expected = 30.0 + degrees(std::asin(kIndex * std::sin(inside)));
    char text[600];
    std::snprintf(text, sizeof text,
                  "[sun]\nelevation = %.3f\ndiameter = 0.0\nspectrum = 550.0\n[ice]\nindex = %.3f\n[[population]]\n"
                  "aspect = 2.0\norientation = \"parry\"\n[camera]\nprojection = \"rectilinear\"\n"
                  "fov_horizontal = 2.0\nresolution = [41, 41]\nelevation = %.3f\n",
                  sun, kIndex, expected);
    const LoadedScene loaded = parseScene(text, "arc.toml");
    const IntegratedSky sky = integrateSky(loaded, 0.05);
    const auto& light = *sky.image.find("G");
    std::size_t brightest = 0;
    for (std::size_t y = 0; y < 41; ++y)
      if (light[y * 41 + 20] > light[brightest * 41 + 20]) brightest = y;
    // Rows are 2 / 41 degrees high, the middle one at the closed form's place.
    CHECK(std::abs(static_cast<double>(brightest) - 20.0) * 2.0 / 41.0 <= 0.1);
    CHECK(light[brightest * 41 + 20] > 0.0F);
  }
}

TEST_CASE("a picture about the sun's vertical has the same bits on both sides, and is the one that its middle cuts") {
  const auto skyOf = [](const char* width, const char* shift) {
    const std::string text = std::string(
                                 "[sun]\nelevation = 20.0\n[[population]]\nname = \"plates\"\naspect = 0.2\n"
                                 "orientation = \"plate\"\ntilt = 1.0\n[camera]\nprojection = \"rectilinear\"\n"
                                 "fov_horizontal = 80.0\nelevation = 25.0\nresolution = [") +
                             width + ", 64]\nshift = [" + shift + ", 0.0]\n";
    return integrateSky(parseScene(text, "mirror.toml"), 0.1).image;
  };
  for (const char* size : {"64", "65"}) {
    CAPTURE(size);
    const Image sky = skyOf(size, "0.0"), whole = skyOf(size, "1e-9");
    const auto width = static_cast<std::size_t>(sky.width);
    for (const Channel& channel : sky.channels) {
      const std::vector<float>& samples = channel.samples;
      double apart = 0.0, all = 0.0;
      std::size_t unlike = 0;
      for (std::size_t i = 0; i < samples.size(); ++i) {
        const std::size_t row = i / width * width;
        // Solid angles of both sides may differ by a rounding.
        const float mirrored = samples[row + (width - 1 - i % width)];
        if (std::abs(samples[i] - mirrored) > 1e-6F * std::abs(mirrored)) ++unlike;
        apart += static_cast<double>(std::abs(samples[i] - (*whole.find(channel.name))[i]));
        all += static_cast<double>(samples[i]);
      }
      CAPTURE(channel.name);
      CHECK(unlike == 0);
      CHECK(apart < 0.01 * all);
    }
  }
}

TEST_CASE("crystals of one tilt and one roll are integrated, those with a spread of either are not") {
  const auto objection = [](const std::string& population) {
    return objectionToIntegratedSky(parseScene("[[population]]\nname = \"p\"\n" + population, "p.toml").scene);
  };
  CHECK(objection("orientation = \"parry\"\n").empty());
  CHECK(objection("orientation = { zenith = 40.0, roll = 7.0 }\n").empty());
  CHECK(objection("orientation = { zenith = 40.0, roll = { normal = [7.0, 0.0] } }\n").empty());
  for (const std::string spread : {"orientation = \"parry\"\ntilt = 0.5\n", "orientation = \"parry\"\nroll = 0.5\n",
                                   "orientation = \"lowitz\"\n", "orientation = { zenith = 90.0, azimuth = 5.0 }\n"}) {
    CAPTURE(spread);
    CHECK(objection(spread).find("population p ") == 0);
  }
}
