// SPDX-License-Identifier: Apache-2.0
#include "trace/scatter_profile.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "math/portable.h"
#include "math/rotation.h"

namespace parhelion {

ScatterProfile::ScatterProfile(int bins, double from, double to)
    : from_(from), width_((to - from) / bins), bins_(bins) {}

int ScatterProfile::binAt(double angle) const {
  // The last bin is closed: light straight back belongs to it.
  const double position = (angle - from_) / width_;
  const int last = bins_.size() - 1;
  if (position < 0.0 || position > (last + 1) * (1.0 + 1e-12)) return kNoBin;
  return std::min(static_cast<int>(position), last);
}

void ScatterProfile::add(std::span<const LightPath> bundle) {
  deposits_.clear();
  bundleCosine_ = bundlePath_ = 0.0;
  for (const LightPath& path : bundle) addPath(path);
  bins_.add(deposits_);
  cosine_.add(bundleCosine_);
  cosineSquared_.add(bundleCosine_ * bundleCosine_);
  path_.add(bundlePath_);
  pathSquared_.add(bundlePath_ * bundlePath_);
  ++bundles_;
}

void ScatterProfile::addPath(const LightPath& path) {
  const double light = path.incident.light.light;
  for (const Exit& exit : path.exits) {
    const double energy = exit.energy * light;
    const double angle = exit.undeviated ? 0.0 : angleBetween(path.incident.lightDirWorld, exit.lightDirWorld);
    if (const int bin = binAt(angle); bin != kNoBin) deposits_.add(bin, energy);
    bundleCosine_ += energy * (exit.undeviated ? 1.0 : glm::dot(path.incident.lightDirWorld, exit.lightDirWorld));
    if (exit.undeviated) undeviated_.add(energy);
    if (exit.order >= static_cast<int>(byOrder_.size())) byOrder_.resize(exit.order + 1);
    byOrder_[exit.order].add(energy);
  }

  ++rays_;
  intercepted_.add(path.incident.weight * light);
  bundlePath_ += path.internalPath * light;
  cutOff_.add(path.cutOff * light);
  lost_.add(path.lost * light);
  // Rays come to crystals in proportion to A; dividing by it counts crystals.
  const double perArea = path.incident.weight / path.incident.projectedArea;
  weight_.add(path.incident.weight);
  perArea_.add(perArea);
  surfacePerArea_.add(perArea * path.incident.crystal.surface());
  volumePerArea_.add(perArea * path.incident.crystal.volume());
}

std::unique_ptr<PathTally> ScatterProfile::forThread() {
  return std::make_unique<ScatterProfile>(bins_.size(), from_, from_ + width_ * bins_.size());
}

void ScatterProfile::merge(PathTally& fromThread) {
  const auto& other = dynamic_cast<const ScatterProfile&>(fromThread);
  bins_.merge(other.bins_);
  rays_ += other.rays_;
  bundles_ += other.bundles_;
  for (const auto sum : {&ScatterProfile::intercepted_, &ScatterProfile::undeviated_, &ScatterProfile::cosine_,
                         &ScatterProfile::cosineSquared_, &ScatterProfile::path_, &ScatterProfile::pathSquared_,
                         &ScatterProfile::cutOff_, &ScatterProfile::lost_, &ScatterProfile::weight_,
                         &ScatterProfile::perArea_, &ScatterProfile::surfacePerArea_, &ScatterProfile::volumePerArea_})
    (this->*sum).merge(other.*sum);
  byOrder_.resize(std::max(byOrder_.size(), other.byOrder_.size()));
  for (std::size_t k = 0; k < other.byOrder_.size(); ++k) byOrder_[k].merge(other.byOrder_[k]);
}

std::vector<ScatterProfile::Bin> ScatterProfile::bins() const {
  std::vector<Bin> bins;
  const double all = intercepted_.value();
  for (int i = 0; i < bins_.size(); ++i) {
    const double from = from_ + i * width_, to = from_ + (i + 1) * width_;
    const double energy = all > 0.0 ? bins_.light(i) / all : 0.0;
    // cos(from) - cos(to), in the form that does not cancel for narrow bins.
    const double solidAngle = 4.0 * kPi * portable::sin(0.5 * (from + to)) * portable::sin(0.5 * (to - from));
    bins.push_back(
        {from, to, energy, all > 0.0 ? bins_.error(i, bundles_) / all : 0.0, 4.0 * kPi * energy / solidAngle});
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
  for (const ExactSum& order : byOrder_) s.byOrder.push_back(order.value() / all);
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
