// SPDX-License-Identifier: Apache-2.0
#include "beam/scatter_integral.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "beam/direction_patch.h"
#include "math/portable.h"
#include "parallel/loops.h"

namespace parhelion {

namespace {

// A regular hexagonal prism looks the same under 24 isometries: a sixth of a right angle of azimuth, and one side of
// the basal plane, stand for all directions. Others, and those whose sides are told apart by the light that is wanted,
// have mirror planes only at their ends.
constexpr double kRegularWidth = kPi / 6.0;
// Where side faces come to light or turn dark, at odd multiples of 30 degrees, patches end.
constexpr int kZetaPatches = 6;

// A patch is not parted more often than this: it is then 2e-4 degrees between nodes.
constexpr int kMostDepth = 12;
// Bins with less light than this share of what they had if it were spread evenly are not refined for their own sake.
constexpr double kDimmest = 1e-4;

// Of what a mesh of half as many nodes differs by: where it errs the same way everywhere, a third is left of smooth
// light, and more where it has bends; where signs are mixed, errors add up as squares. Light of some paths alone ends
// at an edge, where finer meshes gain less.
constexpr double kSystematic = 2.0 / 3.0, kAtEdges = 1.0, kMixed = 1.0;
// The goal is met by this share of what both meshes differ by: errors of bins are then as large as the goal.
constexpr double kOfGoal = 0.36;
// Mean cosine and mean way are aimed at with this share of the bins' error.
constexpr double kBetter = 0.1;
// A bin's error is told with that of so many to either side.
constexpr std::size_t kBeside = 5;

struct Patch {
  PatchBounds bounds;
  int depth = 0;
};

double square(double x) { return x * x; }

std::vector<double> difference(std::vector<double> a, const std::vector<double>& b) {
  for (std::size_t k = 0; k < a.size(); ++k) a[k] -= b[k];
  return a;
}

/// What a patch brings, and what half as many nodes would bring more.
struct PatchLight {
  std::vector<double> light, excess;
  std::vector<double> sampled;  // what other indices of continuous light would bring more; empty for lines
  ScatterTotals totals, coarse;
};

bool isRegular(const PrismSection& section) {
  return std::ranges::all_of(section.distance, [&](double d) { return d == section.distance.front(); });
}

std::vector<Patch> firstPatches(const ScatterScene& scene) {
  const bool isAlike = isRegular(scene.section) && std::ranges::all_of(scene.wanted, &WantedPaths::areAlikeAboutC);
  const double width = isAlike ? kRegularWidth : 2.0 * kPi;
  const int columns = isAlike ? 2 : 24;
  std::vector<Patch> patches;
  for (int row = 0; row < kZetaPatches; ++row)
    for (int column = 0; column < columns; ++column)
      patches.push_back({{width * column / columns, width * (column + 1) / columns, 0.5 * kPi * row / kZetaPatches,
                          0.5 * kPi * (row + 1) / kZetaPatches}});
  return patches;
}

std::array<Patch, 4> quarters(const Patch& patch) {
  const auto [phi0, phi1, zeta0, zeta1] = patch.bounds;
  const double phi = 0.5 * (phi0 + phi1), zeta = 0.5 * (zeta0 + zeta1);
  const int depth = patch.depth + 1;
  return {{{{phi0, phi, zeta0, zeta}, depth},
           {{phi, phi1, zeta0, zeta}, depth},
           {{phi0, phi, zeta, zeta1}, depth},
           {{phi, phi1, zeta, zeta1}, depth}}};
}

class Integration {
 public:
  Integration(const ScatterScene& scene, const ScatterAccuracy& accuracy, int bins, double from, double to)
      : scene_(scene), accuracy_(accuracy), bins_(bins), from_(from), to_(to) {
    const auto size = static_cast<std::size_t>(bins);
    for (auto* sums : {&sum_, &systematic_, &mixed_}) sums->assign(size, 0.0);
  }

  ScatterIntegral run() {
    std::vector<Patch> todo = firstPatches(scene_);
    for (const Patch& patch : todo) {
      area_ += patch.bounds.area();
      const auto [phi0, phi1, zeta0, zeta1] = patch.bounds;
      solidAngle_ += (phi1 - phi0) * (portable::cos(zeta0) - portable::cos(zeta1));
    }
    std::vector<PatchLight> made = make(todo, todo.size());
    expect(made);
    while (!todo.empty()) {
      std::vector<Patch> next;
      for (std::size_t k = 0; k < made.size(); ++k) take(todo[k], made[k], next);
      next.insert(next.end(), todo.begin() + static_cast<std::ptrdiff_t>(made.size()), todo.end());
      todo = std::move(next);
      made = make(todo, kPatchesAtATime);
    }
    return result();
  }

 private:
  /// The light of the first patches, so many at most.
  std::vector<PatchLight> make(const std::vector<Patch>& patches, std::size_t most) {
    std::vector<PatchLight> made(std::min(patches.size(), most));
    forEach(made.size(), [&](std::size_t k) {
      DirectionPatch patch(scene_, solidAngle_, accuracy_.cutShare, accuracy_.detailed);
      const AngleBins none(bins_, from_, to_);
      DirectionPatch::Bins bins{none, none, none};
      patch.add(patches[k].bounds, result_.patches + static_cast<int>(k), bins);
      PatchLight& light = made[k];
      light.light = bins.fine.light();
      light.excess = difference(bins.coarse.light(), bins.fine.light());
      if (scene_.light.isContinuous()) light.sampled = difference(bins.other.light(), bins.coarse.light());
      light.totals = patch.totals(1);
      light.coarse = patch.totals(2);
    });
    result_.patches += static_cast<int>(made.size());
    return made;
  }

  /// What the bins will hold, more or less.
  void expect(const std::vector<PatchLight>& made) {
    expected_.assign(sum_.size(), 0.0);
    for (const PatchLight& patch : made) {
      for (std::size_t bin = 0; bin < expected_.size(); ++bin) expected_[bin] += patch.light[bin];
      intercepted_ += patch.totals.intercepted;
      out_ += patch.totals.out;
      path_ += patch.totals.path;
    }
    // Bins that no wanted light reaches are no better for that.
    const auto dark = scene_.wanted.empty() ? 0 : std::ranges::count(expected_, 0.0);
    lit_ = std::max(1.0, static_cast<double>(bins_) - static_cast<double>(dark));
    const double width = (to_ - from_) / bins_;
    for (std::size_t bin = 0; bin < expected_.size(); ++bin) {
      const double angle = from_ + (static_cast<double>(bin) + 0.5) * width;
      const double even = 0.5 * portable::sin(angle) * width * (scene_.wanted.empty() ? intercepted_ : out_);
      expected_[bin] = std::max(expected_[bin], kDimmest * even);
    }
  }

  void take(const Patch& patch, const PatchLight& made, std::vector<Patch>& next) {
    double squares = 0.0;
    for (std::size_t bin = 0; bin < sum_.size(); ++bin) {
      const double relative = made.excess[bin] / expected_[bin];
      squares += relative * relative;
    }
    // The sums over all light are to be so much better than bins.
    squares += lit_ * (square(made.totals.cosine - made.coarse.cosine) / square(kBetter * intercepted_) +
                       (path_ > 0.0 ? square(made.totals.path - made.coarse.path) / square(kBetter * path_) : 0.0));
    const double allowed = accuracy_.error * accuracy_.error * lit_ * patch.bounds.area() / area_;
    if (kOfGoal * squares > allowed) {
      if (patch.depth < kMostDepth) {
        for (const Patch& quarter : quarters(patch)) next.push_back(quarter);
        return;
      }
      result_.reached = false;
    }
    for (std::size_t bin = 0; bin < sum_.size(); ++bin) {
      sum_[bin] += made.light[bin];
      systematic_[bin] += made.excess[bin];
      mixed_[bin] += made.excess[bin] * made.excess[bin];
    }
    for (std::size_t bin = 0; bin < made.sampled.size(); ++bin) mixed_[bin] += made.sampled[bin] * made.sampled[bin];
    // Sums are smooth: their error falls with the square of the distance of nodes.
    totals_.add(made.totals, 4.0 / 3.0);
    totals_.add(made.coarse, -1.0 / 3.0);
    difference_.add(made.totals, 1.0);
    difference_.add(made.coarse, -1.0);
    cosineSquares_ += square(made.totals.cosine - made.coarse.cosine);
    pathSquares_ += square(made.totals.path - made.coarse.path);
  }

  ScatterIntegral result() {
    const double per = 1.0 / totals_.intercepted;
    std::vector<double> squares;
    for (std::size_t bin = 0; bin < sum_.size(); ++bin) {
      result_.light.push_back(per * sum_[bin]);
      const double systematic = (scene_.wanted.empty() ? kSystematic : kAtEdges) * systematic_[bin];
      squares.push_back(systematic * systematic + kMixed * kMixed * mixed_[bin]);
    }
    // Both meshes may agree by chance in one bin: it is not better than those beside it.
    for (std::size_t bin = 0; bin < squares.size(); ++bin) {
      const std::size_t first = bin < kBeside ? 0 : bin - kBeside, end = std::min(squares.size(), bin + kBeside + 1);
      const double sum = std::accumulate(squares.begin() + static_cast<std::ptrdiff_t>(first),
                                         squares.begin() + static_cast<std::ptrdiff_t>(end), 0.0);
      result_.error.push_back(per * std::sqrt(std::max(squares[bin], sum / static_cast<double>(end - first))));
    }
    result_.totals.add(totals_, per);
    result_.gError = per * std::max(kSystematic * std::abs(difference_.cosine), std::sqrt(cosineSquares_));
    result_.pathError = per * std::max(kSystematic * std::abs(difference_.path), std::sqrt(pathSquares_));
    result_.totals.intercepted = totals_.intercepted / solidAngle_;
    result_.directions =
        static_cast<long>(result_.patches) * (DirectionPatch::kCells + 1) * (DirectionPatch::kCells + 1);
    return std::move(result_);
  }

  const ScatterScene& scene_;
  ScatterAccuracy accuracy_;
  int bins_;
  double from_, to_, area_ = 0.0, solidAngle_ = 0.0;  // of all patches
  std::vector<double> expected_, sum_, systematic_, mixed_;
  ScatterTotals totals_, difference_;
  double intercepted_ = 0.0, out_ = 0.0, path_ = 0.0;  // by the first patches
  double lit_ = 0.0;                                   // bins that have any light
  double cosineSquares_ = 0.0, pathSquares_ = 0.0;
  ScatterIntegral result_;
};

}  // namespace

ScatterIntegral integrateScatter(const ScatterScene& scene, const ScatterAccuracy& accuracy, int bins, double from,
                                 double to) {
  return Integration(scene, accuracy, bins, from, to).run();
}

}  // namespace parhelion
