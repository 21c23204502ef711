// SPDX-License-Identifier: Apache-2.0
#include "photo/find_sky.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "parallel/loops.h"
#include "photo/image_circle.h"
#include "photo/refine_sky.h"
#include "photo/sky_choice.h"
#include "photo/sky_matte.h"
#include "photo/sky_regions.h"
#include "photo/skyline.h"
#include "picture/square_means.h"

namespace parhelion {

namespace {

constexpr int kCoarseRounds = 3;  // of the matte there: into the crowns of trees
constexpr int kFineRounds = 2;    // in each finer picture: over its larger pixels
constexpr int kCoarseSide = 400;  // pixels, of the picture in which the sky is looked for

Image reduced(const Image& image, int reduction) {
  Image small{squaresOver(image.width, reduction), squaresOver(image.height, reduction), {}};
  for (const Channel& channel : image.channels) {
    squareMeans(image.width, image.height, reduction, std::array{small.add(channel.name).data()},
                [&](std::size_t pixel) { return std::array{static_cast<double>(channel.samples[pixel])}; });
  }
  return small;
}

// Upper parts of the picture, first guesses of the sky.
std::vector<Region> guesses(const SkyScene& scene) {
  constexpr std::array<SkylinePrice, 8> kPrices{{{0.05F, 0.01F},
                                                 {0.01F, 0.01F},
                                                 {0.0F, 0.01F},
                                                 {-0.02F, 0.01F},
                                                 {0.05F, 0.05F},
                                                 {0.01F, 0.05F},
                                                 {0.0F, 0.05F},
                                                 {-0.02F, 0.05F}}};
  constexpr std::array kHeights{0.15, 0.3, 0.45, 0.6, 0.75};
  const Raster<float> edges = horizontalEdges(scene);
  std::vector<Region> all;
  for (const SkylinePrice& price : kPrices) all.push_back(aboveSkyline(edges, price));
  for (const double height : kHeights) {
    Region& region = all.emplace_back(scene.colours.width(), scene.colours.height());
    const auto end =
        region.begin() + static_cast<std::ptrdiff_t>(region.index(0, static_cast<int>(height * region.height())));
    std::fill(region.begin(), end, std::uint8_t{1});
  }
  return all;
}

// Whether two guesses would lead to the same sky.
bool nearlyEqual(const Region& a, const Region& b) {
  constexpr double kSame = 0.005;  // of the pixels may differ
  std::size_t different = 0;
  for (std::size_t i = 0; i < a.size(); ++i) different += a[i] != b[i];
  return static_cast<double>(different) < kSame * static_cast<double>(a.size());
}

constexpr float kGrowSteps = 2.0F;  // a smooth sky's neighbours differ by less

std::vector<Region> candidates(const SkyScene& scene) {
  std::vector<Region> starts = guesses(scene), distinct;
  for (Region& start : starts) {
    const bool known =
        std::any_of(distinct.begin(), distinct.end(), [&](const Region& r) { return nearlyEqual(r, start); });
    if (!known) distinct.push_back(std::move(start));
  }
  constexpr std::array kFloodSteps{1.5F, 2.0F, 3.0F, 4.5F};
  Region top(scene.colours.width(), scene.colours.height());
  std::fill(top.begin(), top.begin() + top.width(), std::uint8_t{1});
  const SkyCut cut(scene);
  std::vector<Region> all(kFloodSteps.size() + 3 * distinct.size());
  forEach(kFloodSteps.size() + distinct.size(), [&](std::size_t i) {
    if (i < kFloodSteps.size()) {
      all[i] = grownSky(scene, top, kFloodSteps[i] * scene.step);
      return;
    }
    const std::size_t start = i - kFloodSteps.size(), slot = kFloodSteps.size() + 3 * start;
    all[slot] = distinct[start];
    all[slot + 1] = cut(distinct[start]);
    all[slot + 2] = grownSky(scene, all[slot + 1], kGrowSteps * scene.step);
  });
  return all;
}

// Limits of what sky can look like, from photographs of skies with much texture and of none.
constexpr double kLeastEdge = 0.78;      // clearness of the border, below which there is none
constexpr double kMostSky = 0.98;        // of the picture, above which the rest is a cloud at its lower border
constexpr double kMostThinLines = 0.08;  // share of the sky
constexpr double kMostGreen = 0.3;       // share of the sky
constexpr float kGreen = -0.03F;         // of both opponent colours
constexpr double kLeastLight = 0.4;      // lightness of the sky over that of the land

bool canBeSky(const SkyScene& scene, const Region& region, const SkyMerit& merit) {
  double count = 0.0, green = 0.0, skyLight = 0.0, landLight = 0.0;
  for (std::size_t i = 0; i < region.size(); ++i) {
    const Opponent& colour = scene.colours[i];
    (region[i] != 0 ? skyLight : landLight) += static_cast<double>(colour[0]);
    count += region[i];
    green += region[i] != 0 && colour[1] < kGreen && colour[2] < kGreen;
  }
  const double land = static_cast<double>(region.size()) - count;
  const bool dark = land > 0.0 && skyLight / count < kLeastLight * landLight / land;
  return count > 0.0 && merit.thin < kMostThinLines && green < kMostGreen * count && !dark;
}

Region coarseSky(const SkyScene& scene) {
  const int width = scene.colours.width(), height = scene.colours.height();
  const std::vector<Region> regions = candidates(scene);
  std::vector<SkyMerit> merits(regions.size());
  forEach(regions.size(), [&](std::size_t i) { merits[i] = skyMerit(scene, regions[i]); });
  const std::size_t best = chooseSky(scene, regions, merits);
  Region sky = regions[best];
  const SkyMerit& merit = merits[best];
  const bool border = merit.edge >= kLeastEdge && merit.area <= kMostSky && merit.value() > 0.0;
  if (!border) sky = Region(width, height, 1);
  return canBeSky(scene, sky, skyMerit(scene, sky)) ? sky : Region(width, height, 0);
}

// The region found in a picture of one reduction, in that of another.
Region resampled(const Region& region, int from, int to, int width, int height) {
  Region other(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x)
      other.at(x, y) = region.nearest((2 * x + 1) * to / (2 * from), (2 * y + 1) * to / (2 * from));
  }
  return other;
}

Region moreThanHalf(const Raster<float>& matte) {
  Region region(matte.width(), matte.height());
  for (std::size_t i = 0; i < matte.size(); ++i) region[i] = matte[i] > 0.5F ? 1 : 0;
  return region;
}

}  // namespace

SkyMask findSky(const Image& linear) {
  const std::optional<Region> outside = outsideImageCircle(linear);
  const Image filled = outside ? filledFromInside(linear, *outside) : Image{};
  const Image& picture = outside ? filled : linear;

  // The coarse sky, refined in pictures of more and more pixels.
  int reduction = (std::max(picture.width, picture.height) - 1) / kCoarseSide + 1;
  SkyScene scene = skyScene(reduced(picture, reduction));
  Raster<float> matte = skyMatte(scene, coarseSky(scene), kCoarseRounds);
  while (reduction > 1) {
    const int finer = (reduction + 1) / 2;
    scene = skyScene(reduced(picture, finer));
    matte =
        skyMatte(scene, resampled(moreThanHalf(matte), reduction, finer, scene.colours.width(), scene.colours.height()),
                 kFineRounds);
    reduction = finer;
  }

  SkyMask mask{linear.width, linear.height, std::vector<std::uint8_t>(linear.pixels())};
  for (std::size_t i = 0; i < matte.size(); ++i) {
    const bool out = outside && (*outside)[i] != 0;
    mask.sky[i] = out ? 0 : static_cast<std::uint8_t>(std::lround(255.0F * matte[i]));
  }
  return mask;
}

SkyMask findSky(const Photograph& photograph) {
  constexpr double kSmallPixels = 1e6;  // in which the sky is found
  const double ratio = static_cast<double>(photograph.pixels()) / kSmallPixels;
  const int reduction = std::max(1, static_cast<int>(std::ceil(std::sqrt(ratio))));
  const Image small = linearImage(photograph, reduction);
  const SkyMask found = findSky(small);
  // At the photograph's own size there is nothing finer to follow.
  return reduction == 1 ? found : refineSky(photograph, small, found, reduction);
}

}  // namespace parhelion
