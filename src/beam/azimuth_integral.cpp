// SPDX-License-Identifier: Apache-2.0
#include "beam/azimuth_integral.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "beam/azimuth_sheet.h"
#include "beam/mesh_levels.h"
#include "beam/sheet_integration.h"
#include "beam/sun_slices.h"
#include "parallel/loops.h"

namespace parhelion {

namespace {

// The first mesh: pieces of a turn, for a disc and for a point; parts of the light of a point, colours of that of a
// disc; slices of it, at least and for a radius (rad), and lines across it.
constexpr int kPieces = 12, kPointPieces = 24, kLights = 16, kFewestColours = 6, kFewestSlices = 4, kFewestLines = 4,
              kMostLevel = 6;
constexpr double kSlices = 800.0;
// Cells of the indices at which light is traced, and pieces that are kept at once.
constexpr int kIndices = 2, kAtOnce = 4;
// Lines for a radius in pixels, and colours of all lines for a radian in pixels.
constexpr double kLines = 6.0, kColours = 0.25;
// Each next mesh is finer than the last by this, in all its dimensions.
constexpr double kFiner = 1.4142135623730951;
// Where the first of the colours lies in its part of all light, from line to line.
constexpr double kNextColour = 0.61803398874989484820;

/// An even number.
int atLevel(int level, double first) { return 2 * static_cast<int>(std::ceil(0.5 * first * std::pow(kFiner, level))); }

int slicesAt(int level, double radius) { return atLevel(level, std::max(double{kFewestSlices}, kSlices * radius)); }

int piecesAt(int level, double radius) { return atLevel(level, radius > 0.0 ? kPieces : kPointPieces); }

class AzimuthIntegration : public SheetIntegration {
 public:
  AzimuthIntegration(const AxisScene& scene, const SkyAccuracy& accuracy, const Camera& camera)
      : SheetIntegration(scene, accuracy, camera, Sheets::all, kMostLevel) {}

 private:
  void start(int level) override {
    level_ = level;
    const double radius = scene_.sun.radius;
    sun_.emplace(scene_.sun, slicesAt(level, radius), linesAt(level));
    prisms_ = {scene_.section, scene_.prisms, indices(), accuracy_.cutShare, scene_.wanted};
    if (!scene_.wanted) return;
    const AzimuthLight scout(prisms_, *scene_.rest, sun_->elevations(), turn(), 1, 0, 1);
    wantedShare_ = scout.wantedShare();
  }

  /// Of two crystals that are each other's mirror image one does, where the picture is folded.
  double turn() const { return accuracy_.folds ? kPi : 2.0 * kPi; }

  int linesAt(int level) const {
    return atLevel(level, std::max(double{kFewestLines}, kLines * scene_.sun.radius * lens_.focal));
  }

  long add(int, int, bool) override {
    std::vector<AzimuthStrip> strips;
    if (!scene_.lines.empty())
      addLines(strips);
    else if (scene_.sun.radius > 0.0)
      addColours(strips);
    else
      strips.push_back(colourStrip());
    // Of all light each strip has but a part, of half a turn's twice as much.
    const double parts = static_cast<double>(strips.size() * strips.front().xyz.size()) * turn() / (2.0 * kPi);
    const SheetPicture picture{faintest() / parts, accuracy_.hasEdge, accuracy_.widest};
    const int pieces = piecesAt(level_, scene_.sun.radius) / (accuracy_.folds ? 2 : 1);
    for (int first = 0; first < pieces; first += kAtOnce) {
      const AzimuthLight light(prisms_, *scene_.rest, sun_->elevations(), turn(), pieces, first,
                               std::min(first + kAtOnce, pieces));
      directions_ += light.directions();
      forEach(films_.size(), [&](std::size_t film) {
        AzimuthSheet sheet(light, lens_, picture);
        for (std::size_t k = film; k < strips.size(); k += films_.size())
          totals_[film].add(sheet.add(strips[k], films_[film]), strips[k].share);
      });
    }
    return static_cast<long>(strips.size());
  }

  /// At which light is traced: all that there are, or as many between which others lie.
  std::vector<double> indices() const {
    std::vector<double> all;
    if (scene_.lines.empty() && scene_.sun.radius == 0.0) {
      all = scene_.segments(atLevel(level_, kLights)).indices;
    } else {
      for (const IndexColour& line : scene_.lines) all.push_back(line.index);
    }
    std::ranges::sort(all);
    all.erase(std::ranges::unique(all).begin(), all.end());
    const int count = atLevel(level_, kIndices);
    if (!all.empty() && (all.size() <= static_cast<std::size_t>(count) || scene_.lines.empty())) return all;
    const auto [least, most] = std::ranges::minmax(scene_.indices);
    all.clear();
    for (int k = 0; k <= count; ++k) all.push_back(least + (most - least) * k / count);
    return all;
  }

  /// Light of one index from a line across the sun.
  static AzimuthStrip stripOf(const SunSlices::Line& line, const IndexColour& light, double share, double coarse) {
    AzimuthStrip strip;
    for (std::size_t k = 0; k < line.points.size(); ++k)
      strip.rows.push_back({k, line.points[k].azimuth, light.index, line.points[k].weight});
    strip.xyz.assign(std::max<std::size_t>(line.points.size() - 1, 1), light.xyz);
    strip.share = share;
    strip.coarse = coarse;
    return strip;
  }

  void addLines(std::vector<AzimuthStrip>& strips) const {
    const double part = 1.0 / static_cast<double>(scene_.lines.size());
    for (const SunSlices::Line& line : sun_->lines())
      for (const IndexColour& light : scene_.lines)
        strips.push_back(stripOf(line, light, part * line.share, part * line.coarse));
  }

  /// Continuous light of a disc: each line has its own few indices. Of its parts by the light, each is as bright and of
  /// the colour of all that is in it.
  void addColours(std::vector<AzimuthStrip>& strips) const {
    const double ofAll = kColours * lens_.focal / linesAt(0);
    const int count = atLevel(level_, std::max(double{kFewestColours}, ofAll));
    const double part = 1.0 / count;
    const std::vector<LightSegments::Segment> parts = scene_.segments(count).segments;
    for (std::size_t j = 0; j < sun_->lines().size(); ++j) {
      const SunSlices::Line& line = sun_->lines()[j];
      const double place = kNextColour * static_cast<double>(j + 1), within = place - std::floor(place);
      for (std::size_t k = 0; k < parts.size(); ++k) {
        const IndexColour light{scene_.light((static_cast<double>(k) + within) * part).index, meanOf(parts[k])};
        // Half as many parts have theirs in their first halves and in their second ones by turns.
        const bool isCoarse = k % 2 == j / 2 % 2;
        strips.push_back(stripOf(line, light, part * line.share, isCoarse ? 2.0 * part * line.coarse : 0.0));
      }
    }
  }

  static Tristimulus meanOf(const LightSegments::Segment& segment) {
    Tristimulus mean{};
    for (const Tristimulus& xyz : segment.xyz)
      for (std::size_t c = 0; c < mean.size(); ++c) mean[c] += xyz[c] / LightSegments::kColours;
    return mean;
  }

  /// Continuous light of one point.
  AzimuthStrip colourStrip() const {
    const LightSegments light = scene_.segments(atLevel(level_, kLights));
    AzimuthStrip strip;
    for (const double index : light.indices) strip.rows.push_back({0, sun_->lines()[0].points[0].azimuth, index, 1.0});
    for (const LightSegments::Segment& segment : light.segments) strip.xyz.push_back(meanOf(segment));
    return strip;
  }

  long directions() const override { return directions_; }
  double wantedShare() const override { return wantedShare_; }

  int level_ = 0;
  std::optional<SunSlices> sun_;
  TracedPrisms prisms_;
  double wantedShare_ = 1.0;
  long directions_ = 0;
};

}  // namespace

SkyIntegral integrateAzimuths(const AxisScene& scene, const SkyAccuracy& accuracy, const Camera& camera) {
  return AzimuthIntegration(scene, accuracy, camera).run();
}

std::uint64_t memoryForAzimuths(double sunRadius, double error) {
  constexpr double kClasses = 300.0;  // of a piece, at most
  const int level = MeshLevels{0.08, 1.5, kMostLevel}.firstFor(error);
  const double rows = sunRadius > 0.0 ? slicesAt(level, sunRadius) + 1.0 : 1.0;
  const double indices = 1.0 + atLevel(level, sunRadius > 0.0 ? kIndices : kLights);
  return static_cast<std::uint64_t>(kAtOnce * kClasses * rows * indices * AzimuthLight::kRoom * sizeof(float));
}

}  // namespace parhelion
