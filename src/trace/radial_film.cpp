// SPDX-License-Identifier: Apache-2.0
#include "trace/radial_film.h"

#include <algorithm>

namespace parhelion {

RadialFilm::RadialFilm(std::vector<Tally*> layers, Tally* shared, const Vec3& toSun)
    : layers_(std::move(layers)), shared_(shared) {
  for (Tally* tally : layers_) skies_.push_back(&tally->makeRings(toSun));
  if (shared_) sharedSky_ = &shared_->makeRings(toSun);
}

RadialFilm::RadialFilm(const RadialFilm& whole, ForThread) : layers_(whole.layers_), shared_(whole.shared_) {
  const auto emptyRings = [this, &whole] {
    const Tally& first = *layers_.front();
    own_.push_back(std::make_unique<RadialSky>(first.info, whole.skies_.front()->toCentre(), first.colours()));
    return own_.back().get();
  };
  for (std::size_t layer = 0; layer < layers_.size(); ++layer) skies_.push_back(emptyRings());
  if (shared_) sharedSky_ = emptyRings();
}

std::vector<RadialSky*> RadialFilm::all() const {
  std::vector<RadialSky*> skies = skies_;
  if (sharedSky_) skies.push_back(sharedSky_);
  return skies;
}

int RadialFilm::add(const TracedRays& traced) {
  const auto& [queue, exits, members, population, mesh, steps] = traced;
  const bool isLayered = layers_.size() > 1;
  const Vec3& perWhite = layers_.front()->perWhite();
  byBundle_.sort(queue, exits.ray, exits.count);
  int seen = 0;
  for (int place = 0; place < queue.count; ++place) {
    deposits_.clear();
    for (int i = byBundle_.begin(place); i < byBundle_.begin(place + 1); ++i) {
      const int exit = byBundle_.item(i);
      if (exits.undeviated[exit] != 0.0) continue;
      const Vec3& xyz = queue.light[static_cast<int>(exits.ray[exit])].xyz;
      deposits_.add(skies_.front()->binAt(-exits.lightDir(exit)),
                    isLayered ? exits.layer[static_cast<std::size_t>(exit)] : 0,
                    toFixedLight(exits.energy[exit] * xyz, perWhite));
      ++seen;
    }
    const bool firstHalf = queue.bundle[place] % 2 == 0;
    for (const auto& [ring, layer, light] : deposits_.all())
      skies_[static_cast<std::size_t>(layer)]->add(ring, light, firstHalf);
    if (isLayered)
      deposits_.forShared(
          [this](int ring, std::int64_t squares, std::int64_t hits) { sharedSky_->addShared(ring, squares, hits); });
  }
  return seen;
}

void RadialFilm::merge(Film& fromThread) {
  const std::vector<RadialSky*> own = all(), more = dynamic_cast<RadialFilm&>(fromThread).all();
  for (std::size_t i = 0; i < own.size(); ++i) {
    own[i]->merge(*more[i]);
    more[i]->clear();
  }
}

void RadialFilm::finish() {
  std::vector<RadialSky::Spreading> all;
  for (std::size_t layer = 0; layer < layers_.size(); ++layer) all.push_back({skies_[layer], layers_[layer]});
  RadialSky::spread(all);
}

double RadialFilm::fullness() const {
  double most = 0.0;
  for (const Tally* tally : layers_) most = std::max(most, tally->fullness());
  return most;
}

/// No pixel holds more than all rings together.
double RadialFilm::fullnessAtMost() const {
  double most = 0.0;
  for (const RadialSky* sky : skies_) most = std::max(most, sky->fullnessOfAll());
  return most;
}

void RadialFilm::visitSums(SumVisitor& visitor) {
  for (RadialSky* sky : all()) visitor.visit(sky->sums());
}

}  // namespace parhelion
