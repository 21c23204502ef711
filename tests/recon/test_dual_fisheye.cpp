// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "math/names.h"
#include "recon/synthetic_tally.h"

namespace parhelion {
namespace {

constexpr int kHeight = 128;

TallyInfo dual(Projection projection) {
  TallyInfo info = fullSky(kHeight);
  info.camera.projection = projection;
  info.camera.width = 2 * kHeight;
  info.camera.fieldOfView = kPi;
  return info;
}

/// Poisson hits of a density in the sky, per mean pixel.
template <class Density>
Tally hitsOnSky(const TallyInfo& info, const Density& density, std::uint64_t seed) {
  const Camera camera(info.camera);
  const std::vector<double> solidAngles = camera.solidAngles();
  const int width = camera.width();
  return poissonTally(
      info,
      [&](int x, int y) {
        const double omega = solidAngles[static_cast<std::size_t>(y) * width + x];
        return omega > 0.0 ? density(x, y) * omega * width * kHeight / (4.0 * kPi) : 0.0;
      },
      seed);
}

double sumOf(const std::vector<double>& light, bool left) {
  double sum = 0.0;
  for (std::size_t i = 0; i < light.size(); ++i)
    if ((i % (2 * kHeight) < kHeight) == left) sum += light[i];
  return sum;
}

constexpr Projection kDual[] = {Projection::dualFisheyeEqualArea, Projection::dualFisheyeEquidistant,
                                Projection::dualFisheyeStereographic, Projection::dualFisheyeOrthographic};

}  // namespace

TEST_CASE("no light crosses the seam of a dual fisheye, and none is lost at its rims") {
  for (const Projection projection : kDual) {
    CAPTURE(std::string(nameOf(projection)));
    // Few hits, whose kernels are as wide as a disc, and all of them in the left one, most beside the other.
    const TallyInfo info = dual(projection);
    const Tally tally = hitsOnSky(
        info, [](int x, int) { return x >= kHeight ? 0.0
                                      : x > 110    ? 0.3
                                                   : 0.02; }, 3);
    for (const ReconSettings& settings :
         {ReconSettings(AdaptiveSettings{}), ReconSettings(GaussianSettings{}), ReconSettings(NoSettings{})}) {
      CAPTURE(std::string(nameOf(settings)));
      const std::vector<double> light = perPixel(reconstruct(tally, settings).image, tally);
      CHECK(sumOf(light, false) == 0.0);
      // The Gaussian makes good at the rim what it spreads beyond: a constant sky stays constant, light does not.
      const double tolerance = nameOf(settings) == "gaussian" ? 0.1 : 1e-4;
      CHECK(sumOf(light, true) == doctest::Approx(lightIn(tally)).epsilon(tolerance));
    }
  }
}

TEST_CASE("each disc of a dual fisheye is even up to its rim where the sky is, whatever the other has") {
  for (const Projection projection : kDual) {
    CAPTURE(std::string(nameOf(projection)));
    const TallyInfo info = dual(projection);
    constexpr double kLeft = 30.0, kRight = 300.0;  // hits a mean pixel
    const Image image = adaptive(hitsOnSky(
        info, [](int x, int) { return x < kHeight ? kLeft : kRight; }, 5));
    const std::vector<float>& radiance = *image.find("G");
    const double perHit = 2.0 * kHeight * kHeight / (4.0 * kPi * 1e6);
    const Camera camera(info.camera);
    // In rings about the middle of each disc; the outermost ends at the rim.
    for (const bool left : {true, false}) {
      double sum[8] = {}, count[8] = {};
      for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kHeight; ++x) {
          const int column = left ? x : x + kHeight;
          if (camera.solidAngle(column, y) <= 0.0) continue;
          const double r = std::hypot(x + 0.5 - 0.5 * kHeight, y + 0.5 - 0.5 * kHeight) / (0.5 * kHeight);
          const int ring = std::min(7, static_cast<int>(8.0 * r));
          sum[ring] += static_cast<double>(radiance[static_cast<std::size_t>(y) * 2 * kHeight + column]);
          ++count[ring];
        }
      }
      for (int ring = 0; ring < 8; ++ring) {
        CAPTURE(ring);
        CHECK(sum[ring] / count[ring] == doctest::Approx(perHit * (left ? kLeft : kRight)).epsilon(0.04));
      }
    }
  }
}

}  // namespace parhelion
