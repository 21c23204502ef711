// SPDX-License-Identifier: Apache-2.0
#include "trace/sky_tally_film.h"

#include <algorithm>
#include <stdexcept>

#include "trace/radial_film.h"
#include "trace/sky_film.h"

namespace parhelion {

namespace {

std::unique_ptr<Film> filmOf(SkyTally& tally, std::size_t symmetry, const Vec3& toSun) {
  std::vector<Tally*> layers;
  const std::size_t count = tally.parts().size() / tally.symmetries().size();
  for (std::size_t layer = 0; layer < count; ++layer) layers.push_back(&tally.part(layer, symmetry));
  Tally* shared = tally.shared().empty() ? nullptr : &tally.shared()[symmetry];
  if (tally.symmetries()[symmetry] == TallySymmetry::radial)
    return std::make_unique<RadialFilm>(std::move(layers), shared, toSun);
  return std::make_unique<SkyFilm>(std::move(layers), shared);
}

}  // namespace

SkyTallyFilm::SkyTallyFilm(SkyTally& tally, const std::vector<TallySymmetry>& ofPopulations, const Vec3& toSun)
    : tally_(tally), intercepted_(tally.parts().front().tally) {
  for (std::size_t i = 0; i < tally.symmetries().size(); ++i) films_.push_back(filmOf(tally, i, toSun));
  for (const TallySymmetry symmetry : ofPopulations) {
    const auto found = std::ranges::find(tally.symmetries(), symmetry);
    if (found == tally.symmetries().end()) throw std::invalid_argument("tally: none of its parts has this symmetry");
    filmOf_.push_back(static_cast<std::size_t>(found - tally.symmetries().begin()));
  }
}

SkyTallyFilm::SkyTallyFilm(SkyTallyFilm& whole, std::vector<std::unique_ptr<Film>> films)
    : tally_(whole.tally_),
      filmOf_(whole.filmOf_),
      films_(std::move(films)),
      intercepted_(tally_.parts().front().tally) {}

int SkyTallyFilm::add(const TracedRays& traced) {
  intercepted_.add(traced);
  return films_[filmOf_[static_cast<std::size_t>(traced.population)]]->add(traced);
}

std::unique_ptr<Film> SkyTallyFilm::forThread() {
  std::vector<std::unique_ptr<Film>> films;
  for (const auto& film : films_) films.push_back(film->forThread());
  return std::unique_ptr<SkyTallyFilm>(new SkyTallyFilm(*this, std::move(films)));
}

void SkyTallyFilm::merge(Film& fromThread) {
  auto& other = dynamic_cast<SkyTallyFilm&>(fromThread);
  for (std::size_t i = 0; i < films_.size(); ++i) films_[i]->merge(*other.films_[i]);
  for (SkyTally::Part& part : tally_.parts()) other.intercepted_.addTo(part.tally.info);
  for (SkyTally::Shared& shared : tally_.shared()) other.intercepted_.addTo(shared.info);
  other.intercepted_.clear();
}

void SkyTallyFilm::visitSums(SumVisitor& visitor) {
  for (const auto& film : films_) film->visitSums(visitor);
  for (SkyTally::Part& part : tally_.parts()) part.tally.info.visitTotals(visitor);
  for (SkyTally::Shared& shared : tally_.shared()) shared.info.visitTotals(visitor);
}

void SkyTallyFilm::finish() {
  for (const auto& film : films_) film->finish();
}

void SkyTallyFilm::reopen() {
  for (const auto& film : films_) film->reopen();
}

double SkyTallyFilm::fullness() const {
  double most = 0.0;
  for (const auto& film : films_) most = std::max(most, film->fullness());
  return most;
}

double SkyTallyFilm::fullnessAtMost() const {
  double most = 0.0;
  for (const auto& film : films_) most = std::max(most, film->fullnessAtMost());
  return most;
}

}  // namespace parhelion
