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

ScatterProfile::ScatterProfile(int bins, double from, double to)
    : from_(from), to_(to), width_((to - from) / bins), bins_(bins) {}

int ScatterProfile::binAt(double angle) const {
  // The last bin is closed: light straight back belongs to it.
  const double position = (angle - from_) / width_;
  const int last = bins_.size() - 1;
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
    bins_.add(deposits_);
    cosine_.add(bundleCosine_);
    cosineSquared_.add(bundleCosine_ * bundleCosine_);
    path_.add(bundlePath_);
    pathSquared_.add(bundlePath_ * bundlePath_);
    ++bundles_;
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
  if (undeviated) undeviated_.add(energy);
  orderSum(static_cast<std::size_t>(exits.order[exit])).add(energy);
}

/// Where the light that leaves at an internal encounter is added up.
ExactSum& ScatterProfile::orderSum(std::size_t order) {
  if (order >= byOrder_.size()) byOrder_.resize(std::min(order + 1, kOrders));
  return order < kOrders ? byOrder_[order] : byOrderRest_;
}

void ScatterProfile::addRay(const TracedRays& traced, int member, int place) {
  const RayQueue& queue = traced.queue;
  const int ray = queue.ray(member, place);
  const double light = queue.light[ray].light, weight = queue.weight[place];
  ++rays_;
  intercepted_.add(weight * light);
  bundlePath_ += queue.internalPath[ray] * light;
  cutOff_.add(queue.cutOff[ray] * light);
  lost_.add(queue.lost[ray] * light);
  // Rays come to crystals in proportion to A; dividing by it counts crystals.
  const double perArea = weight / queue.shadow[place];
  const Crystal crystal{&traced.mesh, queue.stretch[place]};
  weight_.add(weight);
  perArea_.add(perArea);
  surfacePerArea_.add(perArea * crystal.surface());
  volumePerArea_.add(perArea * crystal.volume());
}

const std::array<ScatterProfile::Total, 13> ScatterProfile::kTotals{{
    {"intercepted", &ScatterProfile::intercepted_},
    {"undeviated", &ScatterProfile::undeviated_},
    {"cosine", &ScatterProfile::cosine_},
    {"cosine.squares", &ScatterProfile::cosineSquared_},
    {"path", &ScatterProfile::path_},
    {"path.squares", &ScatterProfile::pathSquared_},
    {"cutOff", &ScatterProfile::cutOff_},
    {"lost", &ScatterProfile::lost_},
    {"order.rest", &ScatterProfile::byOrderRest_},
    {"weight", &ScatterProfile::weight_},
    {"perArea", &ScatterProfile::perArea_},
    {"surfacePerArea", &ScatterProfile::surfacePerArea_},
    {"volumePerArea", &ScatterProfile::volumePerArea_},
}};

std::unique_ptr<Film> ScatterProfile::forThread() { return std::make_unique<ScatterProfile>(empty()); }

void ScatterProfile::merge(Film& fromThread) {
  auto& other = dynamic_cast<ScatterProfile&>(fromThread);
  bins_.merge(other.bins_);
  rays_ += other.rays_;
  bundles_ += other.bundles_;
  for (const Total& total : kTotals) (this->*total.sum).merge(other.*total.sum);
  byOrder_.resize(std::max(byOrder_.size(), other.byOrder_.size()));
  for (std::size_t k = 0; k < other.byOrder_.size(); ++k) byOrder_[k].merge(other.byOrder_[k]);
  other = empty();
}

void ScatterProfile::visitSums(SumVisitor& visitor) {
  bins_.visitSums(visitor);
  visitor.visit(rays_);
  visitor.visit(bundles_);
  for (const Total& total : kTotals) visitor.visit(this->*total.sum);
  byOrder_.resize(kOrders);
  for (ExactSum& order : byOrder_) visitor.visit(order);
}

NamedTotals ScatterProfile::totals() const {
  NamedTotals totals{{"bundles", static_cast<ExactSum::Units>(bundles_)},
                     {"rays", static_cast<ExactSum::Units>(rays_)}};
  for (const Total& total : kTotals) totals[total.name] = (this->*total.sum).units();
  for (std::size_t k = 0; k < byOrder_.size(); ++k) totals["order." + std::to_string(k)] = byOrder_[k].units();
  return totals;
}

void ScatterProfile::setTotals(const NamedTotals& totals) {
  bundles_ = static_cast<std::uint64_t>(totals.at("bundles"));
  rays_ = static_cast<std::uint64_t>(totals.at("rays"));
  for (const Total& total : kTotals) this->*total.sum = ExactSum(totals.at(total.name));
  byOrder_.clear();
  for (std::size_t k = 0; k < kOrders; ++k) {
    const auto found = totals.find("order." + std::to_string(k));
    if (found == totals.end()) break;
    byOrder_.emplace_back(found->second);
  }
}

std::vector<ScatterProfile::Bin> ScatterProfile::bins() const {
  std::vector<Bin> bins;
  const double all = intercepted_.value();
  for (int i = 0; i < bins_.size(); ++i) {
    const double from = from_ + i * width_, to = from_ + (i + 1) * width_;
    const double energy = all > 0.0 ? bins_.light(i) / all : 0.0;
    // cos(from) - cos(to), in the form that does not cancel for narrow bins.
    const double solidAngle = 4.0 * kPi * portable::sin(0.5 * (from + to)) * portable::sin(0.5 * (to - from));
    bins.push_back({from, to, energy, bins_.shareError(i, bundles_, all), 4.0 * kPi * energy / solidAngle});
  }
  return bins;
}

double ScatterProfile::errorOf(const ExactSum& sum, const ExactSum& squares) const {
  if (bundles_ == 0) return 0.0;
  const double scatter = squares.value() - sum.value() * sum.value() / static_cast<double>(bundles_);
  return std::sqrt(std::max(0.0, scatter)) / intercepted_.value();
}

ScatterProfile::Summary ScatterProfile::summary() const {
  const double all = rays_ > 0 ? intercepted_.value() : 1.0;
  Summary s{};
  s.rays = rays_;
  s.g = cosine_.value() / all;
  s.gError = errorOf(cosine_, cosineSquared_);
  s.undeviated = undeviated_.value() / all;
  const auto last =
      std::find_if(byOrder_.rbegin(), byOrder_.rend(), [](const ExactSum& sum) { return sum != ExactSum(); });
  for (auto order = byOrder_.begin(); order != last.base(); ++order) s.byOrder.push_back(order->value() / all);
  s.byOrderRest = byOrderRest_.value() / all;
  s.external = s.byOrder.empty() ? 0.0 : s.byOrder[0];
  s.meanPath = path_.value() / all;
  s.meanPathError = errorOf(path_, pathSquared_);
  const double crystals = rays_ > 0 ? perArea_.value() : 1.0;
  s.volume = volumePerArea_.value() / crystals;
  s.surface = surfacePerArea_.value() / crystals;
  s.meanProjectedArea = weight_.value() / crystals;
  s.cutOff = cutOff_.value() / all;
  s.lost = lost_.value() / all;
  return s;
}

}  // namespace parhelion
