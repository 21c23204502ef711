// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <doctest/doctest.h>

#include "sky/camera.h"
#include "sky/radial_skies.h"
#include "statistics.h"

namespace parhelion {
namespace {

/// Every projection, among them pictures with the sun, its antipode, poles, and rings that the border cuts.
std::vector<TallyInfo> pictures() {
  return {info(Projection::fisheyeEqualArea, 180, 200, 200, 90),
          info(Projection::fisheyeEqualArea, 360, 200, 200, 90, 360),
          info(Projection::fisheyeEquidistant, 360, 200, 200, 60, 360),
          info(Projection::fisheyeStereographic, 110, 200, 160, 40),
          info(Projection::fisheyeOrthographic, 180, 200, 200, 90),
          info(Projection::rectilinear, 100, 200, 140, 20),
          info(Projection::rectilinear, 100, 200, 140, -30),
          info(Projection::equirectangular, 360, 200, 110, 0)};
}

/// A sky with this radiance in each ring, times kBright.
constexpr double kBright = 1000.0;
RadialSky skyOf(const TallyInfo& i, const std::function<double(int)>& radiance) {
  RadialSky sky(i, kSun, 1);
  for (int bin = 0; bin < sky.bins(); ++bin) sky.add(bin, Vec3(kBright * radiance(bin) * sky.solidAngle(bin)), false);
  return sky;
}

/// Solid angle per area of the picture, but for a constant factor.
double density(const Camera& camera, const Vec2& pixel) {
  const Vec2 p = (pixel - 0.5 * Vec2(camera.width(), camera.height())) / camera.focalLength();
  const double r2 = glm::dot(p, p), r = std::sqrt(r2);
  switch (camera.settings().projection) {
    case Projection::rectilinear:
      return std::pow(1.0 + r2, -1.5);
    case Projection::fisheyeEqualArea:
      return 1.0;
    case Projection::fisheyeEquidistant:
      return std::sin(r) / r;
    case Projection::fisheyeStereographic:
      return std::pow(1.0 + 0.25 * r2, -2.0);
    case Projection::fisheyeOrthographic:
      return 1.0 / std::sqrt(1.0 - r2);
    default:
      break;
  }
  return std::cos(p.y);
}

constexpr int kSide = 128;  // samples along a pixel's side

struct Sampled {
  double mean;
  double seen;  // share of the pixel that shows sky
};

/// Mean over a pixel of a function of the ring, by one sample at a random place of each of its small squares.
Sampled sampled(const Camera& camera, const RadialSky& sky, int x, int y, const std::function<double(int)>& f) {
  std::minstd_rand random(static_cast<unsigned>(1 + x + 1000 * y));
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  double sum = 0.0, weights = 0.0, seen = 0.0;
  for (int j = 0; j < kSide; ++j) {
    for (int i = 0; i < kSide; ++i) {
      const Vec2 pixel{x + (i + unit(random)) / kSide, y + (j + unit(random)) / kSide};
      const auto toSky = camera.toSky(pixel);
      if (!toSky) continue;
      const double weight = density(camera, pixel);
      weights += weight;
      seen += 1.0;
      sum += weight * f(sky.binAt(*toSky));
    }
  }
  return {sum / weights, seen / (kSide * kSide)};
}

/// Whether a pixel lies wholly in the sky, and whether an angle from the sun passes through it.
bool isWhole(const Camera& camera, int x, int y) {
  for (const Vec2& corner : {Vec2(0, 0), Vec2(1, 0), Vec2(0, 1), Vec2(1, 1)})
    if (!camera.toSky(Vec2(x, y) + corner)) return false;
  return true;
}

bool isCrossed(const Camera& camera, int x, int y, double angle) {
  bool below = false, above = false;
  for (const Vec2& corner : {Vec2(0, 0), Vec2(1, 0), Vec2(0, 1), Vec2(1, 1)})
    if (const auto toSky = camera.toSky(Vec2(x, y) + corner))
      (angleBetween(*toSky, kSun) < angle ? below : above) = true;
  return below && above;
}

/// Errors, relative to a lit whole pixel, of up to `count` of the pixels that an inner edge at `angle` crosses.
std::vector<double> errorsAtEdge(const TallyInfo& i, double angle, bool whole, int count) {
  const Camera camera(i.camera);
  const int edge = RadialSky(i, kSun, 1).binAt(atAngle(angle));
  const auto lit = [edge](int bin) { return bin >= edge ? 1.0 : 0.0; };
  const RadialSky sky = skyOf(i, lit);
  const Tally tally = spread(sky, i);
  std::vector<int> crossed;
  for (int p = 0; p < tally.pixels(); ++p) {
    const int x = p % tally.width(), y = p / tally.width();
    if (isCrossed(camera, x, y, angle) && isWhole(camera, x, y) == whole) crossed.push_back(p);
  }
  std::vector<double> errors;
  const std::size_t step = 1 + crossed.size() / static_cast<std::size_t>(count);
  for (std::size_t k = 0; k < crossed.size(); k += step) {
    const int x = crossed[k] % tally.width(), y = crossed[k] / tally.width();
    const double full = kBright * camera.solidAngle(x, y);
    const Sampled expected = sampled(camera, sky, x, y, lit);
    if (expected.seen > 0.0) errors.push_back((tally.luminance(crossed[k]) / full - expected.mean) * expected.seen);
  }
  return errors;
}

}  // namespace

TEST_CASE("a sky of constant radiance gives each pixel its solid angle") {
  for (const TallyInfo& i : pictures()) {
    CAPTURE(std::string(nameOf(i.camera.projection)));
    const Tally tally = spread(skyOf(i, [](int) { return 1.0; }), i);
    const std::vector<double> solidAngles = Camera(i.camera).solidAngles();
    double worst = 0.0;
    for (int p = 0; p < tally.pixels(); ++p) {
      // Half a unit for the pixel, half a unit for each of its rings' share, which is less together.
      const double rounding = 1.0 / kWeightScale;
      const double off = std::abs(tally.luminance(p) - kBright * solidAngles[static_cast<std::size_t>(p)]);
      worst = std::max(worst, off / rounding);
    }
    CHECK(worst <= 1.0);
  }
}

TEST_CASE("an edge of the profile is spread to 1e-3 of a pixel in every projection") {
  // A sample's ring is wrong only in the squares the edge crosses, at most 2 * kSide, with a variance below 1/4.
  const double sampling = std::sqrt(2.0 * kSide * 0.25) / (kSide * kSide);
  for (const TallyInfo& i : pictures()) {
    for (const double angle : {1.0, 21.84, 120.0, 178.0}) {
      CAPTURE(std::string(nameOf(i.camera.projection)));
      CAPTURE(angle);
      double worst = 0.0, squares = 0.0, count = 0.0;
      for (const double error : errorsAtEdge(i, radians(angle), true, 6)) {
        worst = std::max(worst, std::abs(error));
        squares += error * error;
        count += 1.0;
      }
      if (count > 0.0) CHECK(std::sqrt(squares / count) < 6e-4 + sampling);
    }
  }
}

TEST_CASE("an edge through a panorama's pole is spread to 1e-3 of a pixel") {
  const TallyInfo i = info(Projection::equirectangular, 360, 400, 200, 0);
  const Camera camera(i.camera);
  const double sampling = std::sqrt(2.0 * kSide * 0.25) / (kSide * kSide);
  for (const double row : {0.3, 0.8, 1.6, 2.5, 5.4}) {
    // Towards the sun, away from it, and, where the edge runs along the pixels of a column, in between.
    for (const double longitude : {200.0, 2.0, 90.5, 101.5, 104.0, 120.5}) {
      CAPTURE(row);
      CAPTURE(longitude);
      const Vec3 toEdge = camera.toSky({longitude, row}).value();
      const RadialSky empty(i, kSun, 1);
      const int edge = empty.binAt(toEdge);
      const auto lit = [edge](int bin) { return bin >= edge ? 1.0 : 0.0; };
      const RadialSky sky = skyOf(i, lit);
      const int x = static_cast<int>(longitude), y = static_cast<int>(row);
      const double full = kBright * camera.solidAngle(x, y);
      const double error = spread(sky, i).luminance(y * 400 + x) / full - sampled(camera, sky, x, y, lit).mean;
      CHECK(std::abs(error) < 1e-3 + kSigmas * sampling);
    }
  }
}

TEST_CASE("a picture that is its own mirror image holds the same light as one from all of its pixels") {
  for (const auto& [projection, width] : std::vector<std::pair<Projection, int>>{{Projection::equirectangular, 120},
                                                                                 {Projection::fisheyeEqualArea, 81},
                                                                                 {Projection::rectilinear, 80},
                                                                                 {Projection::globe, 61}}) {
    CAPTURE(std::string(nameOf(projection)));
    TallyInfo i = info(projection,
                       projection == Projection::equirectangular ? 360
                       : projection == Projection::rectilinear   ? 90
                                                                 : 180,
                       width, 60, 12);
    i.camera.roll = 0.0;
    TallyInfo turned = i;
    turned.camera.roll = 1e-12;  // no mirror image any more
    REQUIRE(Camera(i.camera).isMirrorSymmetric());
    REQUIRE_FALSE(Camera(turned.camera).isMirrorSymmetric());
    const auto radiance = [](int bin) { return 1.0 + std::sin(0.01 * bin); };
    const Tally folded = spread(skyOf(i, radiance), i), whole = spread(skyOf(turned, radiance), turned);
    // The turn may tip the decision whether to split a pixel: then it is as good as the accuracy of both.
    double brightest = 0.0;
    for (int p = 0; p < whole.pixels(); ++p) brightest = std::max(brightest, whole.luminance(p));
    for (int p = 0; p < whole.pixels(); ++p)
      CHECK(std::abs(folded.luminance(p) - whole.luminance(p)) < 1e-3 * brightest);
  }
}

TEST_CASE("pixels that the image circle cuts get the light of their part of the sky") {
  // At the rim of an orthographic fisheye 1/32 of a pixel holds a fifth of its sky: there it is coarser.
  const std::vector<std::pair<Projection, double>> bounds{{Projection::fisheyeEqualArea, 4e-3},
                                                          {Projection::fisheyeEquidistant, 4e-3},
                                                          {Projection::fisheyeStereographic, 4e-3},
                                                          {Projection::fisheyeOrthographic, 2e-2}};
  for (const auto& [projection, bound] : bounds) {
    CAPTURE(std::string(nameOf(projection)));
    const TallyInfo i = info(projection, 180, 200, 200, 90);
    int count = 0;
    double worst = 0.0;
    for (const double angle : {21.84, 30.0, 46.0, 80.0, 110.0}) {
      for (const double error : errorsAtEdge(i, radians(angle), false, 10)) {
        worst = std::max(worst, std::abs(error));
        ++count;
      }
    }
    CHECK(count > 5);
    CHECK(worst < bound);
  }
}

TEST_CASE("a panorama of the whole sphere holds the light of the whole profile") {
  const TallyInfo i = info(Projection::equirectangular, 360, 400, 200, 0);
  RadialSky empty(i, kSun, 1);
  const int edge = empty.binAt(atAngle(radians(21.84)));
  const double pixel = empty.bins() / 180.0;  // rings, about
  const auto smooth = [&](int bin) { return bin >= edge ? std::exp(-(bin - edge) / (15.0 * pixel)) : 0.01; };
  const auto glow = [&](int bin) { return std::exp(-bin / pixel) + std::exp(-(empty.bins() - bin) / (0.75 * pixel)); };
  // A glow a pixel wide is spread with the accuracy of single pixels, a smooth sky's errors cancel.
  for (const auto& [radiance, bound] :
       std::vector<std::pair<std::function<double(int)>, double>>{{smooth, 1e-6}, {glow, 1e-4}}) {
    double expected = 0.0, total = 0.0;
    for (int bin = 0; bin < empty.bins(); ++bin) expected += kBright * radiance(bin) * empty.solidAngle(bin);
    const Tally tally = spread(skyOf(i, radiance), i);
    for (int p = 0; p < tally.pixels(); ++p) total += tally.luminance(p);
    CHECK(total == doctest::Approx(expected).epsilon(bound));
  }
}

}  // namespace parhelion
