// SPDX-License-Identifier: Apache-2.0
#include "photo/sky_regions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "math/portable.h"

namespace parhelion {

namespace {

struct Pixel {
  int x, y;
};

constexpr std::array<Pixel, 4> kSides{{{-1, 0}, {1, 0}, {0, -1}, {0, 1}}};
constexpr std::array<Pixel, 8> kAround{{{-1, 0}, {1, 0}, {0, -1}, {0, 1}, {-1, -1}, {1, -1}, {-1, 1}, {1, 1}}};

// Walks from the places in `walk` to all that `enter` lets in (and marks); afterwards `walk` holds all places.
template <class Ways, class Enter>
void flood(std::vector<Pixel>& walk, const Ways& ways, const Enter& enter) {
  for (std::size_t i = 0; i < walk.size(); ++i) {
    const Pixel from = walk[i];
    for (const Pixel& way : ways) {
      const Pixel to{from.x + way.x, from.y + way.y};
      if (enter(from, to)) walk.push_back(to);
    }
  }
}

// For flood(): lets in what is not marked yet and differs little from where the walk comes from.
auto bySmallSteps(const SkyScene& scene, float largestStep, Region& marked) {
  return [&, largestStep](const Pixel& from, const Pixel& to) {
    if (!marked.inside(to.x, to.y) || marked.at(to.x, to.y) != 0) return false;
    const float square = squaredDistance(scene.colours.at(from.x, from.y), scene.colours.at(to.x, to.y));
    if (square >= largestStep * largestStep) return false;
    marked.at(to.x, to.y) = 1;
    return true;
  };
}

}  // namespace

Region withoutIslands(const Region& sky) {
  Region filled(sky.width(), sky.height(), 1);
  std::vector<Pixel> land;
  const auto enter = [&](const Pixel&, const Pixel& to) {
    if (!sky.inside(to.x, to.y) || sky.at(to.x, to.y) != 0 || filled.at(to.x, to.y) == 0) return false;
    filled.at(to.x, to.y) = 0;
    return true;
  };
  for (int x = 0; x < sky.width(); ++x) {
    const Pixel bottom{x, sky.height() - 1};
    if (enter(bottom, bottom)) land.push_back(bottom);
  }
  flood(land, kAround, enter);
  return filled;
}

namespace {

// Only sky that hangs together with the upper border is sky.
Region fromUpperBorder(const Region& sky) {
  Region joined(sky.width(), sky.height());
  std::vector<Pixel> walk;
  const auto enter = [&](const Pixel&, const Pixel& to) {
    if (!sky.inside(to.x, to.y) || sky.at(to.x, to.y) == 0 || joined.at(to.x, to.y) != 0) return false;
    joined.at(to.x, to.y) = 1;
    return true;
  };
  for (int x = 0; x < sky.width(); ++x) {
    if (enter({x, 0}, {x, 0})) walk.push_back({x, 0});
  }
  flood(walk, kSides, enter);
  return joined;
}

// Patches of land in which every step is small.
std::vector<std::vector<Pixel>> landPatches(const SkyScene& scene, const Region& sky, float largestStep) {
  Region seen = sky;
  std::vector<std::vector<Pixel>> patches;
  const auto enter = bySmallSteps(scene, largestStep, seen);
  for (int y = 0; y < sky.height(); ++y) {
    for (int x = 0; x < sky.width(); ++x) {
      if (seen.at(x, y) != 0) continue;
      seen.at(x, y) = 1;
      flood(patches.emplace_back(std::vector<Pixel>{{x, y}}), kSides, enter);
    }
  }
  return patches;
}

// The nearest columns of sky to the left and right in the same row, or -1.
Raster<std::array<int, 2>> skyBeside(const Region& sky) {
  Raster<std::array<int, 2>> beside(sky.width(), sky.height());
  for (int y = 0; y < sky.height(); ++y) {
    for (int x = 0, last = -1; x < sky.width(); ++x) beside.at(x, y)[0] = last = sky.at(x, y) != 0 ? x : last;
    for (int x = sky.width() - 1, last = -1; x >= 0; --x) beside.at(x, y)[1] = last = sky.at(x, y) != 0 ? x : last;
  }
  return beside;
}

constexpr std::size_t kSmallestPatch = 4;  // pixels; a smaller one may look like sky by chance
constexpr int kPatchRounds = 8;            // a patch found helps to find the next
constexpr double kComparedShare = 0.2;     // of a patch must have sky beside it: a lake lies below all of it
constexpr double kMatchingShare = 0.4;     // of those must have its colour
constexpr float kMatchingSteps = 2.0F;     // difference that still is the same colour

bool looksLikeSkyBeside(const SkyScene& scene, const std::vector<Pixel>& patch,
                        const Raster<std::array<int, 2>>& beside) {
  const float tolerance = kMatchingSteps * scene.step;
  std::size_t compared = 0, matching = 0;
  for (const Pixel& pixel : patch) {
    bool any = false, match = false;
    for (const int x : beside.at(pixel.x, pixel.y)) {
      if (x < 0 || 3 * std::abs(x - pixel.x) >= beside.width()) continue;  // too far away to tell
      any = true;
      match = match ||
              squaredDistance(scene.colours.at(pixel.x, pixel.y), scene.colours.at(x, pixel.y)) < tolerance * tolerance;
    }
    compared += any;
    matching += match;
  }
  return compared >= kSmallestPatch &&
         static_cast<double>(compared) >= kComparedShare * static_cast<double>(patch.size()) &&
         static_cast<double>(matching) >= kMatchingShare * static_cast<double>(compared);
}

void addSkyInGaps(const SkyScene& scene, Region& sky, float largestStep) {
  std::vector<std::vector<Pixel>> patches = landPatches(scene, sky, largestStep);
  std::erase_if(patches, [](const auto& patch) { return patch.size() < kSmallestPatch; });
  bool found = true;
  for (int round = 0; round < kPatchRounds && found; ++round) {
    const auto beside = skyBeside(sky);
    const auto erased = std::erase_if(patches, [&](const std::vector<Pixel>& patch) {
      if (!looksLikeSkyBeside(scene, patch, beside)) return false;
      for (const Pixel& pixel : patch) sky.at(pixel.x, pixel.y) = 1;
      return true;
    });
    found = erased > 0;
  }
}

constexpr int kCutRounds = 2;
constexpr float kLargestEvidence = 3.0F;  // nats of one pixel's colour: no single pixel decides alone
constexpr float kGuessEvidence = 0.7F;    // nats for the first guess: 2 to 1
constexpr float kGround = 50.0F;          // nats for land along the lower border, never outweighed
constexpr float kLinkCost = 8.0F;         // nats to separate equal neighbours
constexpr float kEdgeCost = 0.02F;        // of that remains across the strongest edge, so that borders are short
constexpr float kDiagonal = 0.7F;         // of that for diagonal neighbours, farther away
constexpr float kRoughStep = 0.05F;       // mean difference of neighbours where half a nat speaks against sky

Raster<float> roughness(const SkyScene& scene) {
  constexpr int kReach = 2;
  const auto& colours = scene.colours;
  Raster<float> steps(colours.width(), colours.height()), rough(colours.width(), colours.height());
  for (int y = 0; y < colours.height(); ++y) {
    for (int x = 0; x < colours.width(); ++x) {
      steps.at(x, y) = std::sqrt(squaredDistance(colours.at(x, y), colours.nearest(x + 1, y)) +
                                 squaredDistance(colours.at(x, y), colours.nearest(x, y + 1)));
    }
  }
  for (int y = 0; y < colours.height(); ++y) {
    for (int x = 0; x < colours.width(); ++x) {
      float sum = 0.0F;
      for (int dy = -kReach; dy <= kReach; ++dy) {
        for (int dx = -kReach; dx <= kReach; ++dx) sum += steps.nearest(x + dx, y + dy);
      }
      const float ratio = sum / ((2 * kReach + 1) * (2 * kReach + 1)) / kRoughStep;
      rough.at(x, y) = ratio * ratio / (1.0F + ratio * ratio);
    }
  }
  return rough;
}

MinCut linkedNeighbours(const SkyScene& scene) {
  MinCut cut(scene.colours.size());
  const auto& colours = scene.colours;
  const double scale = 0.5 / (1.5 * static_cast<double>(scene.step * scene.step));
  const auto link = [&](int x, int y, int dx, int dy, float weight) {
    if (!colours.inside(x + dx, y + dy)) return;
    const float square = squaredDistance(colours.at(x, y), colours.at(x + dx, y + dy));
    const auto alike = static_cast<float>(portable::exp(-scale * static_cast<double>(square)));
    cut.edge(colours.index(x, y), colours.index(x + dx, y + dy),
             weight * kLinkCost * (kEdgeCost + (1.0F - kEdgeCost) * alike));
  };
  for (int y = 0; y < colours.height(); ++y) {
    for (int x = 0; x < colours.width(); ++x) {
      link(x, y, 1, 0, 1.0F);
      link(x, y, 0, 1, 1.0F);
      link(x, y, 1, 1, kDiagonal);
      link(x, y, -1, 1, kDiagonal);
    }
  }
  return cut;
}

}  // namespace

Region grownSky(const SkyScene& scene, const Region& sky, float largestStep) {
  Region grown = sky;
  std::vector<Pixel> walk;
  for (int y = 0; y < sky.height(); ++y) {
    for (int x = 0; x < sky.width(); ++x) {
      if (sky.at(x, y) != 0) walk.push_back({x, y});
    }
  }
  flood(walk, kSides, bySmallSteps(scene, largestStep, grown));
  grown = withoutIslands(grown);
  addSkyInGaps(scene, grown, largestStep);
  return withoutIslands(grown);
}

SkyCut::SkyCut(const SkyScene& scene) : scene_(scene), rough_(roughness(scene)), links_(linkedNeighbours(scene)) {}

Region SkyCut::operator()(const Region& guess) const {
  Region sky = guess;
  for (int round = 0; round < kCutRounds; ++round) {
    ColourHistogram ofSky, ofLand;
    for (std::size_t i = 0; i < sky.size(); ++i) (sky[i] != 0 ? ofSky : ofLand).add(scene_.colours[i]);
    const double least = sky.width();  // pixels to learn colours from
    if (ofSky.total() < least || ofLand.total() < least) return sky;
    MinCut cut = links_;
    for (std::size_t i = 0; i < sky.size(); ++i) {
      const double ratio = ofSky.density(scene_.colours[i]) / ofLand.density(scene_.colours[i]);
      float evidence = std::clamp(static_cast<float>(portable::log(ratio)), -kLargestEvidence, kLargestEvidence);
      evidence += (guess[i] != 0 ? kGuessEvidence : -kGuessEvidence) - rough_[i];
      if (i >= sky.index(0, sky.height() - 1)) evidence = -kGround;
      cut.terminals(i, std::max(evidence, 0.0F), std::max(-evidence, 0.0F));
    }
    cut.run();
    for (std::size_t i = 0; i < sky.size(); ++i) sky[i] = cut.onSourceSide(i) ? 1 : 0;
    sky = withoutIslands(fromUpperBorder(sky));
  }
  return sky;
}

}  // namespace parhelion
