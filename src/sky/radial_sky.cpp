// SPDX-License-Identifier: Apache-2.0
#include "sky/radial_sky.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <stdexcept>

#include "math/lanes.h"
#include "sky/camera.h"
#include "sky/picture_parts.h"
#include "sky/radial_footprint.h"
#include "sky/tally.h"

namespace parhelion {
namespace {

/// The smallest step of a pixel along a radius of the picture, as a chord on the unit sphere; the horizon does not
/// matter.
double smallestPixel(CameraSettings settings) {
  settings.horizon = Horizon::keep;
  const Camera camera(settings);
  // A panorama's pixels are as high everywhere; that they get narrow near its poles needs no finer rings.
  if (isPanorama(camera.settings().projection)) return 1.0 / camera.focalLength();
  const SkyBorder border(camera);
  const Vec2 centre = camera.axis(), corner = camera.farthestCorner();
  double smallest = 1.0 / camera.focalLength();
  for (const Vec2& side : {Vec2(corner.x, centre.y), Vec2(centre.x, corner.y), corner}) {
    const Vec2 outer = camera.directionAt(side) ? side : border.moved(side);
    const auto a = camera.directionAt(outer), b = camera.directionAt(outer + glm::normalize(centre - outer));
    if (a && b) smallest = std::min(smallest, glm::distance(*a, *b));
  }
  return smallest;
}

/// An even number of rings, so that one ends at 90 degrees.
int ringsFor(const CameraSettings& camera) {
  // Few large pixels need rings as fine as the halos themselves: 0.02 to 0.03 degrees keep an edge where it is.
  constexpr int kFewestRings = 1 << 13, kMostRings = 1 << 16;
  const double wanted = std::max<double>(kFewestRings, 8.0 * 2.0 * std::sqrt(2.0) / smallestPixel(camera));
  return wanted < kMostRings ? 2 * static_cast<int>(std::ceil(0.5 * wanted)) : kMostRings;
}

}  // namespace

RadialSky::RadialSky(const TallyInfo& info, const Vec3& toCentre, int colours)
    : toCentre_(toCentre),
      colours_(colours),
      rings_(static_cast<std::size_t>(ringsFor(partsOf(info.camera).front().camera))) {
  if (colours != 1 && colours != 3) throw std::invalid_argument("radial sky: colours must be 1 or 3");
  perChord_ = static_cast<double>(bins()) / (2.0 * std::sqrt(2.0));
  perWhite_ = perWhiteOf(info.white);
}

void RadialSky::requireSameRings(const RadialSky& other) const {
  if (toCentre_ != other.toCentre_ || perWhite_ != other.perWhite_ || colours_ != other.colours_ ||
      bins() != other.bins()) {
    throw std::invalid_argument("radial sky: centre, rings or colours differ");
  }
}

void RadialSky::merge(const RadialSky& other) {
  requireSameRings(other);
  addLines(rings_, other.rings_);
}

void RadialSky::subtract(const RadialSky& other) {
  requireSameRings(other);
  subtractLines(rings_, other.rings_);
}

double RadialSky::fullnessOfAll() const {
  std::array<double, 8> sums{};
  for (const SumLine& ring : rings_)
    for (std::size_t k = 0; k < sums.size(); ++k) sums[k] += static_cast<double>(ring.place[k]);
  return std::ranges::max(sums) / 0x1p63;
}

bool RadialSky::fitsPixels() const {
  constexpr double kSafe = 0.5;  // far from 1 by the rounding of these sums
  return fullnessOfAll() < kSafe;
}

/// What each ring gives for its share in a pixel: all sums in proportion to the share, but the squares and hits in
/// proportion to its square.
struct RadialSky::Densities {
  // First the places that go with the share, in the order of kLinear, then the squares and those of hits.
  static constexpr std::array kLinear{Tally::kY, Tally::kFirstHalf, Tally::kHits, Tally::kX, Tally::kZ};
  static constexpr std::size_t kHits = 2, kSquares = 6, kSquaredHits = 7;
  static_assert(kLinear[kHits] == Tally::kHits);
  std::vector<std::array<double, 8>> ofRings;

  explicit Densities(const RadialSky& sky) : ofRings(sky.rings_.size()) {
    for (int bin = 0; bin < sky.bins(); ++bin) {
      const double perSolidAngle = 1.0 / sky.solidAngle(bin);
      const auto& ring = sky.rings_[static_cast<std::size_t>(bin)].place;
      auto& density = ofRings[static_cast<std::size_t>(bin)];
      for (std::size_t k = 0; k < kLinear.size(); ++k)
        density[k] = perSolidAngle * static_cast<double>(ring[kLinear[k]]);
      density[kSquares] = perSolidAngle * static_cast<double>(ring[Tally::kSquares]) * perSolidAngle;
      density[kSquaredHits] = perSolidAngle * density[kHits];
    }
  }

  /// The integers of a pixel.
  SumLine over(const RadialFootprint& footprint) const {
    using Two = Lanes<2>::Real;
    Two linear[3]{}, square{};
    for (int bin = footprint.first(); bin <= footprint.last(); ++bin) {
      const double* density = ofRings[static_cast<std::size_t>(bin)].data();
      const double w = footprint.solidAngle(bin);
      for (int k = 0; k < 3; ++k) linear[k] += w * load<Two>(density + 2 * k);
      square += w * w * load<Two>(density + kSquares);
    }
    std::array<double, 6> sums{};
    std::memcpy(sums.data(), linear, sizeof(linear));
    // n hits of one weight have the square of their sum n times the sum of their squares.
    if (square[1] > 0.0) sums[kHits] *= sums[kHits] / square[1];
    SumLine pixel;
    for (std::size_t k = 0; k < kLinear.size(); ++k) pixel.place[kLinear[k]] = toFixed(sums[k], 1.0);
    pixel.place[Tally::kSquares] = toFixed(square[0], 1.0);
    return pixel;
  }
};

bool RadialSky::isDark() const {
  return std::ranges::all_of(rings_, [](const SumLine& ring) { return ring == SumLine{}; });
}

void RadialSky::spreadOver(Tally& tally) const {
  const Spreading one[] = {{this, &tally}};
  spread(one);
}

void RadialSky::spread(std::span<const Spreading> all) {
  if (all.empty()) return;
  const RadialSky& first = *all.front().sky;
  std::vector<Spreading> lit;
  for (const auto& [sky, tally] : all) {
    if (tally->colours() != sky->colours_) throw std::invalid_argument("radial sky: the tally's colours differ");
    first.requireSameRings(*sky);
    if (tally->info.camera != all.front().tally->info.camera)
      throw std::invalid_argument("radial sky: the tallies' cameras differ");
    if (sky->isDark())
      tally->clearPixels();
    else
      lit.push_back({sky, tally});
  }
  if (lit.empty()) return;
  std::vector<Densities> densities;
  for (const auto& [sky, tally] : lit) densities.emplace_back(*sky);
  const int width = lit.front().tally->width();
  for (const PicturePart& part : partsOf(lit.front().tally->info.camera)) {
    const Camera camera(part.camera);
    // Where the right half shows the mirror image of the left, the left is enough.
    const bool folds = camera.isMirrorSymmetric() && first.toCentre_.y == 0.0;
    const int columns = folds ? (camera.width() + 1) / 2 : camera.width();
    RadialFootprint footprint(camera, first, columns);
    for (int y = 0; y < camera.height(); ++y) {
      footprint.setRow(y);
      for (int x = 0; x < columns; ++x) {
        footprint.setPixel(x);
        const int left = y * width + part.left, mirrored = camera.width() - 1 - x;
        for (std::size_t i = 0; i < lit.size(); ++i) {
          const SumLine sums = densities[i].over(footprint);
          Tally& tally = *lit[i].tally;
          tally.setRaw(left + x, sums);
          if (folds) tally.setRaw(left + mirrored, sums);
        }
      }
    }
  }
}

}  // namespace parhelion
