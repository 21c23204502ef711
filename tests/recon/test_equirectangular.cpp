// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "recon/synthetic_tally.h"

namespace parhelion {
namespace {

TallyInfo wholeSky(int height) {
  TallyInfo info = fullSky(2 * height);
  info.camera.projection = Projection::equirectangular;
  info.camera.height = height;
  info.camera.elevation = 0.0;
  info.camera.fieldOfView = 2.0 * kPi;
  return info;
}

/// Hits by a density in the sky, per mean pixel, of longitude and latitude.
template <class Density>
Tally hitsOnSky(const TallyInfo& info, const Density& density, std::uint64_t seed) {
  const std::vector<double> solidAngles = Camera(info.camera).solidAngles();
  const int width = info.camera.width, height = info.camera.height;
  const double mean = 4.0 * kPi / (width * height);
  return poissonTally(
      info,
      [&](int x, int y) {
        const double longitude = 2.0 * kPi * ((x + 0.5) / width - 0.5), latitude = kPi * (0.5 - (y + 0.5) / height);
        return density(longitude, latitude) * solidAngles[static_cast<std::size_t>(y) * width + x] / mean;
      },
      seed);
}

}  // namespace

TEST_CASE("an even sky is even up to the poles of an equirectangular picture") {
  constexpr int kHeight = 128, kWidth = 2 * kHeight;
  constexpr double kHits = 100.0;  // per mean pixel
  const Image image = adaptive(hitsOnSky(
      wholeSky(kHeight), [&](double, double) { return kHits; }, 31));
  const std::vector<float>& radiance = *image.find("G");
  const double even = kHits * kWidth * kHeight / (4.0 * kPi * 1e6);
  // The row at a pole holds 500 hits, 4.5 % of scatter before any filter, and its kernels reach over several rows.
  for (int y = 0; y < kHeight; ++y) {
    double mean = 0.0;
    for (int x = 0; x < kWidth; ++x)
      mean += static_cast<double>(radiance[static_cast<std::size_t>(y) * kWidth + x]) / (kWidth * even);
    INFO("row " << y);
    CHECK(mean == doctest::Approx(1.0).epsilon(0.03));
  }
}

TEST_CASE("turning an equirectangular picture turns its reconstruction") {
  const TallyInfo info = wholeSky(128);
  // A ring across the seam, one about a pole, and a faint rest.
  const Tally tally = hitsOnSky(
      info,
      [](double longitude, double latitude) {
        const double fromSeam = std::acos(-std::cos(longitude) * std::cos(latitude));
        return 0.5 + 20.0 * std::exp(-0.5 * std::pow((fromSeam - 0.4) / 0.03, 2)) +
               20.0 * std::exp(-0.5 * std::pow((latitude - 1.3) / 0.03, 2));
      },
      32);
  constexpr int kTurn = 128;
  Tally turned(info, 1);
  for (int y = 0; y < 128; ++y) {
    for (int x = 0; x < 256; ++x) {
      for (int slot = 0; slot < tally.slots(); ++slot)
        turned.setRaw(y * 256 + (x + kTurn) % 256, slot, tally.raw(y * 256 + x, slot));
    }
  }
  const std::vector<double> plain = adaptiveLight(tally), moved = adaptiveLight(turned);
  double differences = 0.0, seam = 0.0;
  for (int y = 0; y < 128; ++y) {
    for (int x : {0, 1, 2, 3, 252, 253, 254, 255}) {
      const double here = plain[static_cast<std::size_t>(y * 256 + x)];
      const double difference = moved[static_cast<std::size_t>(y * 256 + (x + kTurn) % 256)] - here;
      differences += difference * difference;
      seam += here * here;
    }
  }
  // Kernels of the bank are steps, which the last bits may tip: not the same, but nearly.
  CHECK(std::sqrt(differences / seam) < 0.03);
}

}  // namespace parhelion
