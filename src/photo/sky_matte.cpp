// SPDX-License-Identifier: Apache-2.0
#include "photo/sky_matte.h"

#include <algorithm>
#include <cmath>

#include "parallel/loops.h"
#include "photo/sky_regions.h"

namespace parhelion {

namespace {

constexpr int kBand = 2;             // pixels from the border that may be mixtures
constexpr int kWindow = 8;           // pixels in which the colours on both sides are looked up
constexpr float kLeastSteps = 3.0F;  // difference of the two colours that can be divided
constexpr float kSameSteps = 2.0F;   // differences up to this are noise and gradient
constexpr float kMostBeside = 4.0F;  // steps from the line between the two colours for what is no mixture
constexpr float kDeadShare = 0.1F;   // of the way between the two is noise and texture

// Whether a pixel is all sky or all land: far from the border and in a smooth place, for branches too thin to be seen
// in a smaller picture may cross the sky, and hide sky between them.
bool isUnmixed(const SkyScene& scene, const Region& region, int x, int y) {
  const float same = kSameSteps * scene.step;
  for (int dy = -kBand; dy <= kBand; ++dy) {
    for (int dx = -kBand; dx <= kBand; ++dx) {
      if (region.nearest(x + dx, y + dy) != region.at(x, y)) return false;
      if (std::abs(dx) > 1 || std::abs(dy) > 1) continue;
      if (squaredDistance(scene.colours.at(x, y), scene.colours.nearest(x + dx, y + dy)) > same * same) return false;
    }
  }
  return true;
}

struct WeightedColour {
  Opponent sum{};
  float weight = 0.0F;

  void add(const Opponent& colour, float w) {
    for (std::size_t c = 0; c < 3; ++c) sum[c] += w * colour[c];
    weight += w;
  }
  Opponent mean() const { return {sum[0] / weight, sum[1] / weight, sum[2] / weight}; }
};

template <class F>
void eachInWindow(const Region& region, int x, int y, const F& f) {
  for (int j = std::max(0, y - kWindow); j <= std::min(region.height() - 1, y + kWindow); ++j) {
    for (int i = std::max(0, x - kWindow); i <= std::min(region.width() - 1, x + kWindow); ++i) f(i, j);
  }
}

// What is known of a region's pixels: in it or not, and whether all about them is the same.
struct Labels {
  const Region& region;
  const Region& unmixed;
};

float skyShare(const SkyScene& scene, const Labels& labels, int x, int y) {
  const Region& region = labels.region;
  const Opponent& colour = scene.colours.at(x, y);
  const float asLabelled = region.at(x, y) != 0 ? 1.0F : 0.0F;
  // Where unmixed pixels of its own side have the same colour the pixel is no mixture.
  const float same = kSameSteps * scene.step;
  bool mixture = true;
  WeightedColour sky;
  eachInWindow(region, x, y, [&](int i, int j) {
    const Opponent& other = scene.colours.at(i, j);
    if (region.at(i, j) != 0) sky.add(other, 1.0F);
    if (labels.unmixed.at(i, j) == 0 || region.at(i, j) != region.at(x, y)) return;
    mixture = mixture && squaredDistance(other, colour) > same * same;
  });
  if (!mixture || sky.weight <= 0.0F) return asLabelled;
  // Among thin branches most pixels are mixtures: those farthest from the other side's colour count most.
  const auto purest = [&](bool ofSky, const Opponent& otherSide) {
    WeightedColour sum;
    eachInWindow(region, x, y, [&](int i, int j) {
      if ((region.at(i, j) != 0) != ofSky) return;
      const float square = squaredDistance(scene.colours.at(i, j), otherSide);
      sum.add(scene.colours.at(i, j), square * square);
    });
    return sum;
  };
  const WeightedColour land = purest(false, sky.mean());
  if (land.weight <= 0.0F) return asLabelled;
  const Opponent l = land.mean();
  sky = purest(true, l);
  if (sky.weight <= 0.0F) return asLabelled;
  const Opponent s = sky.mean();
  const float square = squaredDistance(l, s), least = kLeastSteps * scene.step;
  if (square < least * least) return asLabelled;
  float along = 0.0F;
  for (std::size_t c = 0; c < 3; ++c) along += (colour[c] - s[c]) * (l[c] - s[c]);
  // A mixture of the two lies on the line between them.
  const float beside = squaredDistance(colour, s) - along * along / square, most = kMostBeside * scene.step;
  if (beside > most * most) return asLabelled;
  // Light mixes linearly; lightness is the square root of it.
  const float rootShare = 1.0F - std::clamp(along / square, 0.0F, 1.0F);
  const float lightness = l[0] + (s[0] - l[0]) * rootShare;
  const float share = rootShare * (lightness + l[0]) / (s[0] + l[0]);
  return std::clamp((share - kDeadShare) / (1.0F - 2.0F * kDeadShare), 0.0F, 1.0F);
}

}  // namespace

Raster<float> skyMatte(const SkyScene& scene, Region region, int rounds) {
  Raster<float> matte(region.width(), region.height());
  Region unmixed(region.width(), region.height());
  for (int round = 0; round < rounds; ++round) {
    forRows(region.height(), [&](int y) {
      for (int x = 0; x < region.width(); ++x) unmixed.at(x, y) = isUnmixed(scene, region, x, y) ? 1 : 0;
    });
    forRows(region.height(), [&](int y) {
      for (int x = 0; x < region.width(); ++x) {
        const float asLabelled = region.at(x, y) != 0 ? 1.0F : 0.0F;
        matte.at(x, y) = unmixed.at(x, y) != 0 ? asLabelled : skyShare(scene, {region, unmixed}, x, y);
      }
    });
    for (std::size_t i = 0; i < region.size(); ++i) region[i] = matte[i] > 0.5F ? 1 : 0;
    // What is dark but hangs on nothing is cloud.
    region = withoutIslands(region);
    for (std::size_t i = 0; i < region.size(); ++i) matte[i] = region[i] != 0 && matte[i] <= 0.5F ? 1.0F : matte[i];
  }
  return matte;
}

}  // namespace parhelion
