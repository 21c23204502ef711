// SPDX-License-Identifier: Apache-2.0
#include "trace/many_orders.h"

#include <algorithm>
#include <cmath>

#include "math/portable.h"

namespace parhelion {

namespace {

// Of haze, all of whose crystals are taken: the mean interception of convex bodies in any orientation (Cauchy).
constexpr double kRandomShadow = 0.25;

/// The most that crystals of a population intercept per surface, from whatever side light comes. The shadow of a
/// convex body is V . d for the sum V of its lit faces' areas along their normals, so that it is at most |V|: found
/// for each set of lit faces that light from many directions makes.
double mostIntercepted(const FaceTable& faces, double stretch) {
  constexpr int kDirections = 4096;
  constexpr double kGoldenTurn = 0.6180339887498949, kMargin = 1.005, kMost = 0.5;
  double most = 0.0;
  for (int k = 0; k < kDirections; ++k) {
    const double z = 1.0 - (2.0 * k + 1.0) / kDirections, r = std::sqrt(1.0 - z * z);
    const portable::SinCos turn = portable::sincos(2.0 * kPi * kGoldenTurn * k);
    Vec3 lit(0.0);
    for (int f = 0; f < faces.faces; ++f) {
      const Vec3 normal(faces.normal[0][f], faces.normal[1][f], faces.normal[2][f]);
      if (normal.x * r * turn.cos + normal.y * r * turn.sin + normal.z * z > 0.0)
        lit += normal * (faces.areaGrows[f] != 0.0 ? faces.area[f] * stretch : faces.area[f]);
    }
    most = std::max(most, std::sqrt(lit.x * lit.x + lit.y * lit.y + lit.z * lit.z));
  }
  return std::min(kMost, kMargin * most / (faces.surfaceAcrossC + faces.surfaceAlongC * stretch));
}

double mostIntercepted(const FaceTable& faces, const AngleQuantile* stretch) {
  if (!stretch) return mostIntercepted(faces, 1.0);
  constexpr int kStretches = 17;
  double most = 0.0;
  for (int k = 0; k < kStretches; ++k)
    most = std::max(most, mostIntercepted(faces, stretch->at((k + 0.01) / (kStretches - 0.98))));
  return most;
}

/// Those that have any weight.
// A population whose shapes are spread is so many of one shape each.
constexpr int kShapes = 32;

std::vector<PopulationSettings> withWeight(const std::vector<PopulationSettings>& all) {
  std::vector<PopulationSettings> some;
  for (const PopulationSettings& one : all)
    if (one.weight > 0.0) std::ranges::copy(withFixedShapes(one, kShapes), std::back_inserter(some));
  return some;
}

}  // namespace

double takenOver(double depth) { return depth < 1e-5 ? depth - 0.5 * depth * depth : 1.0 - portable::exp(-depth); }

ManyOrders::ManyOrders(SlabContents contents, const SlabSettings& slab, const Extinction& extinction, Engine engine)
    : sun_(contents.sun),
      disc_(sun_.isPoint() ? nullptr : std::make_unique<SunDisc>(sun_.disc())),
      spectrum_(contents.sun.spectrum),
      ice_(contents.ice),
      depth_(extinction, slab.opticalDepth),
      orders_(slab.orders),
      scattered_(takenOver(depth_.along(sun_.toCentre()))),
      someMesh_(meshOf(PrismSettings{})) {
  double all = 0.0;
  if (const auto populations = withWeight(contents.populations); !populations.empty()) {
    cloud_.emplace(contents.sun, contents.ice, populations);
    engines_ = makeIntersectors(*cloud_, engine);
    paths_.emplace(*cloud_, PathSettings{});
    for (int p = 0; p < static_cast<int>(populations.size()); ++p) {
      const Population& population = cloud_->populations()[static_cast<std::size_t>(p)];
      const double bound = mostIntercepted(cloud_->faces(p), population.stretch());
      all += population.weight() * bound;
      kinds_.push_back({p, false, bound, all});
    }
  }
  for (const HazeSettings& haze : contents.hazes) {
    all += haze.weight * kRandomShadow;
    kinds_.push_back({static_cast<int>(phases_.size()), true, kRandomShadow, all});
    phases_.emplace_back(haze.phase);
  }
  for (Kind& kind : kinds_) kind.below /= all;
}

const ManyOrders::Kind& ManyOrders::kindAt(double u) const {
  const auto found = std::ranges::upper_bound(kinds_, u, {}, &Kind::below);
  return found == kinds_.end() ? kinds_.back() : *found;
}

Vec3 ManyOrders::sunlight(double u1, double u2) const {
  if (!disc_) return -sun_.toCentre();
  const Triple<double> toSun = disc_->toPoint(u1, u2);
  return {-toSun.x, -toSun.y, -toSun.z};
}

SpectralSample ManyOrders::light(double u) const {
  const auto& lines = spectrum_.lines();
  if (lines.empty()) return spectrum_.sample(u);
  return lines[std::min(static_cast<std::size_t>(u * static_cast<double>(lines.size())), lines.size() - 1)];
}

}  // namespace parhelion
