// SPDX-License-Identifier: Apache-2.0
#include "beam/ring_integral.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "beam/band_light.h"
#include "beam/mesh_levels.h"
#include "math/portable.h"

namespace parhelion {

namespace {

// The coarsest mesh: bands, cells for 30 degrees of azimuth, parts of continuous light. Each next has more by this.
constexpr int kBands = 70, kColumns = 12, kLights = 2;
constexpr double kFiner = 1.5;
constexpr MeshLevels kLevels{0.03, 1.8, 6};
// What the coarse mesh differs by, times this, is the error: on average over so many rings on each side, which together
// are about as wide as a pixel.
constexpr double kOfCoarse = 0.35;
// And what they differ by on average, relative, times this.
constexpr double kOfMean = 2.0;
constexpr int kNear = 2;
// Even light in a band is corrected to second order.
constexpr double kOfBand = 1.0 / 12.0;
constexpr std::size_t kAtOnce = 16;

class RingIntegration {
 public:
  RingIntegration(const AxisScene& scene, const SkyAccuracy& accuracy, int rings)
      : scene_(scene), accuracy_(accuracy), rings_(rings) {}

  RingIntegral run() {
    for (level_ = kLevels.firstFor(accuracy_.error);; ++level_) {
      integrate();
      const double own = error();
      for (std::size_t ring = 0; ring < result_.error.size(); ++ring)
        result_.error[ring] = std::hypot(result_.error[ring], kOfMean * own * result_.light[ring][1]);
      result_.reached = error() <= accuracy_.error;
      if (result_.reached || level_ == kLevels.most) break;
    }
    return std::move(result_);
  }

 private:
  void integrate() {
    const double finer = std::pow(kFiner, level_);
    const auto evenly = [&](int count) { return 2 * static_cast<int>(std::lround(0.5 * count * finer)); };
    BandMesh mesh;
    mesh.bands = evenly(kBands);
    mesh.rings = mesh.end = rings_;
    mesh.cells = kNoTurns;
    const CosineTable cosines(mesh.cells);
    LightTable table(scene_.prisms, scene_.indices, evenly(kColumns), mesh.bands, accuracy_.cutShare, scene_.wanted);
    table.prepare(0.0, 0.5 * kPi);
    const bool colours = scene_.hasColours();
    const int lights = evenly(kLights);
    BandLight light(table, cosines, mesh, colours, scene_.segments(lights), scene_.segments(lights / 2));
    const double thick = 0.5 * kPi / mesh.bands;
    const auto shareOf = [&](int band) { return portable::cos(band * thick) - portable::cos((band + 1) * thick); };
    std::vector<std::array<double, 4>> sums(static_cast<std::size_t>(rings_));
    result_.totals = {};
    std::vector<BandLight::Band> made(kAtOnce);
    for (int first = 0; first < mesh.bands; first += static_cast<int>(kAtOnce)) {
      std::vector<int> numbers(std::min(kAtOnce, static_cast<std::size_t>(mesh.bands - first)));
      std::iota(numbers.begin(), numbers.end(), first);
      light.make(numbers, made);
      for (std::size_t k = 0; k < numbers.size(); ++k) {
        const double own = shareOf(numbers[k]), pair = 0.5 * (own + shareOf(numbers[k] ^ 1)),
                     fine = own - kOfBand * (shareOf(numbers[k] - 1) - 2.0 * own + shareOf(numbers[k] + 1));
        result_.totals.add(made[k].totals, own);
        addBand(light, made[k], fine, pair, sums);
      }
    }
    take(sums, colours);
    result_.directions += table.directions();
  }

  void addBand(const BandLight& light, const BandLight::Band& band, double fine, double coarse,
               std::vector<std::array<double, 4>>& sums) const {
    const int channels = light.channels();
    for (int ring = 0; ring < rings_; ++ring) {
      const auto r = static_cast<std::size_t>(ring);
      if (!band.lit[r]) continue;
      // Of the cosines, that of order 0 is all light.
      const float* const orders = band.light.data() + light.layout().placeOf(ring);
      for (int c = 0; c < channels; ++c) {
        const double weight = c == channels - 1 ? coarse : fine;
        sums[r][static_cast<std::size_t>(c)] += weight * static_cast<double>(orders[2 * c * light.layout().room(ring)]);
      }
    }
  }

  void take(const std::vector<std::array<double, 4>>& sums, bool colours) {
    const auto count = static_cast<std::size_t>(rings_);
    const Tristimulus grey = colours ? Tristimulus{} : scene_.lines.front().xyz;
    result_.light.resize(count);
    result_.error.resize(count);
    const auto off = [&](std::size_t ring) {
      return colours ? sums[ring][3] - sums[ring][1] : grey[1] * (sums[ring][1] - sums[ring][0]);
    };
    for (std::size_t ring = 0; ring < count; ++ring) {
      for (std::size_t c = 0; c < 3; ++c) result_.light[ring][c] = colours ? sums[ring][c] : grey[c] * sums[ring][0];
      const std::size_t first = ring - std::min<std::size_t>(ring, kNear), end = std::min(count, ring + kNear + 1);
      double sum = 0.0;
      for (std::size_t near = first; near < end; ++near) sum += off(near);
      result_.error[ring] = kOfCoarse * std::abs(sum) / static_cast<double>(end - first);
    }
  }

  double error() const {
    double errors = 0.0, light = 0.0;
    for (std::size_t ring = 0; ring < result_.light.size(); ++ring) {
      errors += result_.error[ring];
      light += result_.light[ring][1];
    }
    return light > 0.0 ? errors / light : 0.0;
  }

  const AxisScene& scene_;
  SkyAccuracy accuracy_;
  int rings_, level_ = 0;
  RingIntegral result_;
};

}  // namespace

const RingIntegral* RingStore::find(const Kind& kind) {
  const auto here = std::ranges::find(kept_, kind, &std::pair<Kind, RingIntegral>::first);
  if (here != kept_.end()) return &here->second;
  if (elsewhere_.find) found_ = elsewhere_.find(kind);
  if (!found_) return nullptr;
  addHere(kind, *found_);
  return &*found_;
}

void RingStore::add(const Kind& kind, const RingIntegral& rings) {
  addHere(kind, rings);
  if (elsewhere_.keep) elsewhere_.keep(kind, rings);
}

void RingStore::addHere(const Kind& kind, const RingIntegral& rings) {
  constexpr std::size_t kMost = 64;
  if (kept_.size() < kMost) kept_.emplace_back(kind, rings);
}

RingIntegral integrateRings(const AxisScene& scene, const SkyAccuracy& accuracy, int rings, RingStore& store) {
  if (scene.wanted) return RingIntegration(scene, accuracy, rings).run();
  const RingStore::Kind kind{scene.prisms,   scene.indices,     scene.segments(kLights),
                             accuracy.error, accuracy.cutShare, rings};
  if (const RingIntegral* kept = store.find(kind)) {
    RingIntegral same = *kept;
    same.directions = 0;
    return same;
  }
  RingIntegral made = RingIntegration(scene, accuracy, rings).run();
  store.add(kind, made);
  return made;
}

}  // namespace parhelion
