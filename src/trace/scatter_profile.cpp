// SPDX-License-Identifier: Apache-2.0
#include "trace/scatter_profile.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <glm/geometric.hpp>

#include "crystal/crystal.h"
#include "math/portable.h"
#include "math/rotation.h"

namespace parhelion {

namespace {

// Rounding may put light straight back this far beyond the last bin, as a share of the range of angles: a thousand
// times what the division by the bins' width leaves.
constexpr double kBeyondLastBin = 1e-12;

}  // namespace

std::array<std::string, ScatterProfile::kTotalCount> ScatterProfile::namesOfTotals() {
  std::array<std::string, kTotalCount> names;
  names[kIntercepted] = kInterceptedName;
  names[kUndeviated] = "undeviated";
  names[kCosine] = "cosine";
  names[kCosineSquared] = "cosine.squares";
  names[kPath] = "path";
  names[kPathSquared] = "path.squares";
  names[kCutOff] = "cutOff";
  names[kLost] = "lost";
  names[kWeight] = "weight";
  names[kPerArea] = "perArea";
  names[kSurfacePerArea] = "surfacePerArea";
  names[kVolumePerArea] = "volumePerArea";
  names[kOrderRest] = "order.rest";
  for (std::size_t k = 0; k < kOrders; ++k) names[kFirstOrder + k] = "order." + std::to_string(k);
  return names;
}

const std::array<std::string, ScatterProfile::kTotalCount> ScatterProfile::kTotals = namesOfTotals();

ScatterProfile::ScatterProfile(int bins, double from, double to)
    : MeasuringFilm(bins, kTotals), from_(from), to_(to), width_((to - from) / bins) {}

int ScatterProfile::binAt(double angle) const {
  // The last bin is closed: light straight back belongs to it.
  const double position = (angle - from_) / width_;
  const int last = sums().size() - 1;
  if (position < 0.0 || position > (last + 1) * (1.0 + kBeyondLastBin)) return kNoBin;
  return std::min(static_cast<int>(position), last);
}

int ScatterProfile::add(const TracedRays& traced) {
  byBundle_.sort(traced.queue, traced.exits.ray, traced.exits.count);
  for (int place = 0; place < traced.queue.count; ++place) {
    deposits_.clear();
    bundleCosine_ = bundlePath_ = 0.0;
    for (int i = byBundle_.begin(place); i < byBundle_.begin(place + 1); ++i) addExit(traced, byBundle_.item(i));
    for (int member = 0; member < traced.members; ++member) addRay(traced, member, place);
    addBundle(deposits_, traced.members);
    total(kCosine).add(bundleCosine_);
    total(kCosineSquared).add(bundleCosine_ * bundleCosine_);
    total(kPath).add(bundlePath_);
    total(kPathSquared).add(bundlePath_ * bundlePath_);
  }
  return traced.exits.count;
}

void ScatterProfile::addExit(const TracedRays& traced, int exit) {
  const auto& [queue, exits, members, population, mesh, steps] = traced;
  const int ray = static_cast<int>(exits.ray[exit]), place = queue.placeOf(ray);
  const double energy = exits.energy[exit] * queue.light[ray].light;
  const bool undeviated = exits.undeviated[exit] != 0.0;
  const Vec3 incident(queue.lightWorld[0][place], queue.lightWorld[1][place], queue.lightWorld[2][place]);
  const double angle = undeviated ? 0.0 : angleBetween(incident, exits.lightDir(exit));
  if (const int bin = binAt(angle); bin != kNoBin) deposits_.add(bin, energy);
  bundleCosine_ += energy * (undeviated ? 1.0 : glm::dot(incident, exits.lightDir(exit)));
  if (undeviated) total(kUndeviated).add(energy);
  const auto order = static_cast<std::size_t>(exits.order[exit]);
  total(order < kOrders ? kFirstOrder + order : kOrderRest).add(energy);
}

void ScatterProfile::addRay(const TracedRays& traced, int member, int place) {
  const RayQueue& queue = traced.queue;
  const int ray = queue.ray(member, place);
  const double light = queue.light[ray].light, weight = queue.weight[place];
  total(kIntercepted).add(weight * light);
  bundlePath_ += queue.internalPath[ray] * light;
  total(kCutOff).add(queue.cutOff[ray] * light);
  total(kLost).add(queue.lost[ray] * light);
  // Rays come to crystals in proportion to A; dividing by it counts crystals.
  const double perArea = weight / queue.shadow[place];
  const Crystal crystal{&traced.mesh, queue.stretch[place]};
  total(kWeight).add(weight);
  total(kPerArea).add(perArea);
  total(kSurfacePerArea).add(perArea * crystal.surface());
  total(kVolumePerArea).add(perArea * crystal.volume());
}

std::unique_ptr<Film> ScatterProfile::forThread() {
  return std::make_unique<ScatterProfile>(sums().size(), from_, to_);
}

ScatterProfile::Bin ScatterProfile::binOf(int i, double from, double width, double energy, double error) {
  const double begin = from + i * width, end = from + (i + 1) * width;
  // cos(begin) - cos(end), in the form that does not cancel for narrow bins.
  const double solidAngle = 4.0 * kPi * portable::sin(0.5 * (begin + end)) * portable::sin(0.5 * (end - begin));
  return {begin, end, energy, error, 4.0 * kPi * energy / solidAngle};
}

std::vector<ScatterProfile::Bin> ScatterProfile::bins() const {
  std::vector<Bin> bins;
  const double all = valueOf(kIntercepted);
  for (int i = 0; i < sums().size(); ++i)
    bins.push_back(
        binOf(i, from_, width_, all > 0.0 ? sums().light(i) / all : 0.0, sums().shareError(i, bundles(), all)));
  return bins;
}

double ScatterProfile::errorOf(Total sum, Total squares) const {
  if (bundles() == 0) return 0.0;
  const double scatter = valueOf(squares) - valueOf(sum) * valueOf(sum) / static_cast<double>(bundles());
  return std::sqrt(std::max(0.0, scatter)) / valueOf(kIntercepted);
}

ScatterProfile::Summary ScatterProfile::summary() const {
  const double all = rays() > 0 ? valueOf(kIntercepted) : 1.0;
  Summary s{};
  s.rays = rays();
  s.g = valueOf(kCosine) / all;
  s.gError = errorOf(kCosine, kCosineSquared);
  s.undeviated = valueOf(kUndeviated) / all;
  for (std::size_t k = 0; k < kOrders; ++k) s.byOrder.push_back(valueOf(kFirstOrder + k) / all);
  while (!s.byOrder.empty() && s.byOrder.back() == 0.0) s.byOrder.pop_back();
  s.byOrderRest = valueOf(kOrderRest) / all;
  s.external = s.byOrder.empty() ? 0.0 : s.byOrder[0];
  s.meanPath = valueOf(kPath) / all;
  s.meanPathError = errorOf(kPath, kPathSquared);
  const double crystals = rays() > 0 ? valueOf(kPerArea) : 1.0;
  s.volume = valueOf(kVolumePerArea) / crystals;
  s.surface = valueOf(kSurfacePerArea) / crystals;
  s.meanProjectedArea = valueOf(kWeight) / crystals;
  s.cutOff = valueOf(kCutOff) / all;
  s.lost = valueOf(kLost) / all;
  return s;
}

}  // namespace parhelion
