// SPDX-License-Identifier: Apache-2.0
#include "trace/many_orders.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "math/portable.h"
#include "trace/flight_places.h"

namespace parhelion {

namespace {

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

// A population whose shapes are spread is so many of one shape each.
constexpr int kShapes = 32;

/// What is left of light along a way, 1 at its start: the mean over the way.
double meanLeft(double depth) { return depth < 1e-9 ? 1.0 : takenOver(depth) / depth; }

}  // namespace

ManyOrders::ManyOrders(SlabContents contents, int orders, const SlabStack& stack, Engine engine)
    : sun_(contents.sun),
      disc_(sun_.isPoint() ? nullptr : std::make_unique<SunDisc>(sun_.disc())),
      spectrum_(contents.sun.spectrum),
      ice_(contents.ice),
      orders_(orders),
      someMesh_(meshOf(PrismSettings{})) {
  std::vector<PopulationSettings> populations;
  for (const PopulationSettings& one : contents.populations) {
    if (one.weight > 0.0) std::ranges::copy(withFixedShapes(one, kShapes), std::back_inserter(populations));
    populationEnds_.push_back(populations.size());
  }
  if (!populations.empty()) {
    cloud_.emplace(contents.sun, contents.ice, populations);
    engines_ = makeIntersectors(*cloud_, engine);
    paths_.emplace(*cloud_, PathSettings{});
  }
  for (const HazeSettings& haze : contents.hazes) phases_.emplace_back(haze.phase);
  for (const SlabStack::Layer& layer : stack.layers())
    layers_.push_back({SlabDepth(layer.extinction, layer.opticalDepth), kindsOf(contents, layer)});
  scattered_ = takenOver(depthFrom({}, -sun_.toCentre()));
}

std::vector<ManyOrders::Kind> ManyOrders::kindsOf(const SlabContents& contents, const SlabStack::Layer& layer) const {
  std::vector<Kind> kinds;
  double all = 0.0;
  for (const std::size_t number : layer.populations)
    for (std::size_t p = number > 0 ? populationEnds_[number - 1] : 0; p < populationEnds_[number]; ++p) {
      const Population& population = cloud_->populations()[p];
      const double bound = mostIntercepted(cloud_->faces(static_cast<int>(p)), population.stretch());
      all += population.weight() * bound;
      kinds.push_back({static_cast<int>(p), false, bound, all});
    }
  for (const std::size_t haze : layer.hazes) {
    all += contents.hazes[haze].weight * kRandomShadow;
    kinds.push_back({static_cast<int>(haze), true, kRandomShadow, all});
  }
  for (Kind& kind : kinds) kind.below /= all;
  return kinds;
}

const ManyOrders::Kind& ManyOrders::kindAt(std::size_t layer, double u) const {
  const std::vector<Kind>& kinds = layers_[layer].kinds;
  const auto found = std::ranges::upper_bound(kinds, u, {}, &Kind::below);
  return found == kinds.end() ? kinds.back() : *found;
}

SlabCrossing ManyOrders::crossing(std::size_t layer, const Vec3& direction) const {
  SlabCrossing all{layers_[layer].depth.along(direction), 0.0, direction.z < 0.0};
  if (layers_.size() == 1) return all;
  for (std::size_t other = 0; other < layers_.size(); ++other)
    if (all.goesDown ? other > layer : other < layer) all.beyond += layers_[other].depth.along(direction);
  return all;
}

SlabPlace ManyOrders::onward(SlabPlace place, const Vec3& direction, double share) const {
  const bool goesDown = direction.z < 0.0;
  if (layers_.size() == 1) {
    place.down += share * (goesDown ? 1.0 - place.down : -place.down);
    return place;
  }
  double left = share * depthFrom(place, direction);
  for (;;) {
    const double whole = layers_[place.layer].depth.along(direction);
    const double reach = whole * (goesDown ? 1.0 - place.down : place.down);
    const bool isLast = place.layer == (goesDown ? layers_.size() - 1 : 0);
    if (left <= reach || isLast) {
      place.down = std::clamp(place.down + (goesDown ? left : -left) / whole, 0.0, 1.0);
      return place;
    }
    left -= reach;
    place = goesDown ? SlabPlace{place.layer + 1, 0.0} : SlabPlace{place.layer - 1, 1.0};
  }
}

SlabWay ManyOrders::wayTo(const SlabPlace& place, const SlabPlace& start, const Vec3& direction) const {
  const bool goesDown = direction.z < 0.0;
  SlabWay way{place.layer, goesDown ? 0.0 : 1.0, goesDown ? 1.0 : 0.0, 0.0, 1.0};
  if (start.layer == place.layer) way.from = start.down;
  way.depth = layers_[way.layer].depth.along(direction) * std::abs(way.to - way.from);
  way.meanLeft = meanLeft(way.depth);
  return way;
}

double ManyOrders::meanOut(const SlabWay& way, const SlabCrossing& out) const {
  // Depths grow evenly along the way, toward the place and from it, so that the mean is an integral of exp.
  const double atStart = out.depthFrom(way.from), atEnd = out.depthFrom(way.to) + way.depth;
  return portable::exp(-std::min(atStart, atEnd)) * meanLeft(std::abs(atEnd - atStart)) / way.meanLeft;
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
