// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "recon/adaptive/adaptive_filter.h"
#include "synthetic_tally.h"

namespace parhelion {
namespace {

/// A sharp bright spot of millions of hits with a faint patch around it, and some thousand stray hits in the rest of
/// the sky: their kernels are as wide as the picture.
struct Spot {
  TallyInfo info;
  int x = 0, y = 0;    // of the spot
  double patch = 0.0;  // radius, pixels
  double stray = 0.0;  // hits a pixel

  Tally tally() const {
    const double middleX = 0.5 * info.camera.width, middleY = 0.5 * info.camera.height;
    Tally result = poissonTally(
        info,
        [&](int px, int py) {
          if (std::hypot(px - x, py - y) < patch) return 0.3;
          return std::hypot(px - middleX, py - middleY) < 0.9 * std::min(middleX, middleY) ? stray : 0.0;
        },
        17);
    const int pixel = y * info.camera.width + x;
    const auto add = [&](int slot, double amount, double scale) {
      result.setRaw(pixel, slot, result.raw(pixel, slot) + toFixed(amount, scale));
    };
    constexpr double kPile = 1e7;
    add(Tally::kY, kPile, kWeightScale);
    add(Tally::kFirstHalf, 0.5 * kPile, kWeightScale);
    add(Tally::kSquares, kPile, kSquareScale);
    add(Tally::kHits, kPile, 1.0);
    return result;
  }
};

Spot spotIn(int width, int height, double fieldOfView) {
  Spot spot;
  spot.info = fullSky(width);
  spot.info.camera.height = height;
  spot.info.camera.fieldOfView = radians(fieldOfView);
  spot.x = 2 * width / 5;
  spot.y = height / 4;
  spot.patch = std::min(width, height) / 10.0;
  spot.stray = 2000.0 / (width * height);
  return spot;
}

/// Light of the filtered picture over that of its hits, before anything is rescaled.
double keptLight(const Tally& tally) {
  const SkyPyramid sky(tally.width(), tally.height(), Camera(tally.info.camera).solidAngles());
  Raster<Light<2>> light(sky.width(), sky.height());
  double given = 0.0, kept = 0.0;
  for (std::size_t i = 0; i < light.size(); ++i) {
    const int pixel = static_cast<int>(i);
    if (sky.pixels().omega[i] <= 0.0F) continue;
    light[i] = {static_cast<float>(tally.luminance(pixel)),
                static_cast<float>(2.0 * tally.firstHalf(pixel) - tally.luminance(pixel))};
    given += tally.luminance(pixel);
  }
  const Filtered filtered = adaptiveFilter<2>(sky, light, given, Watch{});
  for (std::size_t i = 0; i < light.size(); ++i)
    kept += static_cast<double>(filtered.luminance[i][0] * sky.pixels().omega[i]);
  return kept / given;
}

/// Brightest pixel of the plain picture, of the adaptive one, and of the latter far from the spot.
struct Peaks {
  float plain = 0.0F, adaptive = 0.0F, dark = 0.0F;
};

Peaks peaksOf(const Spot& spot) {
  const Tally tally = spot.tally();
  const Image plain = plainRadiance(tally), smooth = adaptive(tally);
  Peaks peaks;
  for (int y = 0; y < tally.height(); ++y) {
    for (int x = 0; x < tally.width(); ++x) {
      const std::size_t i = static_cast<std::size_t>(y) * tally.width() + x;
      const float here = (*smooth.find("G"))[i];
      peaks.plain = std::max(peaks.plain, (*plain.find("G"))[i]);
      peaks.adaptive = std::max(peaks.adaptive, here);
      if (std::hypot(x - spot.x, y - spot.y) > 3.0 * spot.patch) peaks.dark = std::max(peaks.dark, here);
    }
  }
  return peaks;
}

void checkSpot(const Spot& spot) {
  INFO(spot.info.camera.width << " x " << spot.info.camera.height);
  INFO(spot.info.camera.fieldOfView << " rad");
  const Peaks peaks = peaksOf(spot);
  CHECK(peaks.adaptive > 0.5F * peaks.plain);
  CHECK(peaks.adaptive < 2.0F * peaks.plain);
  CHECK(peaks.dark < 1e-5F * peaks.plain);
  CHECK(keptLight(spot.tally()) == doctest::Approx(1.0).epsilon(0.03));
}

}  // namespace

TEST_CASE("a spot keeps its peak and the rest of the sky its darkness, whatever the picture's size") {
  for (const double fieldOfView : {90.0, 180.0, 360.0}) {
    for (int side = 64; side <= 160; ++side) checkSpot(spotIn(side, side, fieldOfView));
    for (const int side : {300, 321}) checkSpot(spotIn(side, side, fieldOfView));
    checkSpot(spotIn(150, 75, fieldOfView));
  }
}

TEST_CASE("hits all over an image circle's border keep their light") {
  for (int side = 64; side <= 160; side += 3) {
    for (const double fieldOfView : {180.0, 360.0}) {
      TallyInfo info = fullSky(side);
      info.camera.fieldOfView = radians(fieldOfView);
      const double middle = 0.5 * (side - 1);
      const Tally tally = poissonTally(
          info, [&](int x, int y) { return std::hypot(x - middle, y - middle) > 0.4 * side ? 5.0 : 0.2; }, 18);
      INFO(side << " pixels, " << fieldOfView << " degrees");
      CHECK(keptLight(tally) == doctest::Approx(1.0).epsilon(0.05));
    }
  }
}

TEST_CASE("pictures of a pixel, a row, a column and a few pixels keep their light") {
  const int sizes[][2] = {{1, 1}, {1, 2}, {2, 1}, {1, 64}, {64, 1}, {2, 2}, {3, 3}};
  for (const auto& [width, height] : sizes) {
    for (const int count : {1, 1000}) {
      TallyInfo info = fullSky(width);
      info.camera.height = height;
      info.camera.projection = Projection::equirectangular;
      Tally tally(info, 1);
      addHits(tally, tally.pixels() / 2, count);
      INFO(width << " x " << height << ", " << count << " hits");
      const std::vector<double> light = adaptiveLight(tally);
      double sum = 0.0;
      for (const double l : light) {
        CHECK(l >= 0.0);
        sum += l;
      }
      CHECK(sum == doctest::Approx(count).epsilon(1e-6));
    }
  }
}

}  // namespace parhelion
