// SPDX-License-Identifier: Apache-2.0
#include "trace/expose.h"

#include <algorithm>

#include "trace/sky_tally_film.h"

namespace parhelion {

namespace {

/// The most that a population allows.
TallySymmetry symmetryOf(const Population& population) {
  if (population.isFullyRandom()) return TallySymmetry::radial;
  return population.isMirrorSymmetric() ? TallySymmetry::mirror : TallySymmetry::none;
}

Symmetry namedLike(TallySymmetry symmetry) {
  switch (symmetry) {
    case TallySymmetry::mirror:
      return Symmetry::mirror;
    case TallySymmetry::radial:
      return Symmetry::radial;
    case TallySymmetry::none:
      break;
  }
  return Symmetry::none;
}

}  // namespace

std::vector<TallySymmetry> symmetriesOf(const Cloud& cloud, Symmetry asked) {
  std::vector<TallySymmetry> symmetries;
  for (const Population& population : cloud.populations()) {
    switch (asked) {
      case Symmetry::automatic:
        symmetries.push_back(symmetryOf(population));
        break;
      case Symmetry::none:
        symmetries.push_back(TallySymmetry::none);
        break;
      case Symmetry::mirror:
        symmetries.push_back(TallySymmetry::mirror);
        break;
      case Symmetry::radial:
        symmetries.push_back(TallySymmetry::radial);
        break;
    }
  }
  return symmetries;
}

std::vector<TallySymmetry> different(std::vector<TallySymmetry> symmetries) {
  std::ranges::sort(symmetries);
  symmetries.erase(std::unique(symmetries.begin(), symmetries.end()), symmetries.end());
  return symmetries;
}

Symmetry symmetryOf(const Cloud& cloud, Symmetry asked) {
  const std::vector<TallySymmetry> all = different(symmetriesOf(cloud, asked));
  return all.size() == 1 ? namedLike(all.front()) : Symmetry::automatic;
}

std::unique_ptr<Film> makeFilm(SkyTally& tally, const Cloud& cloud, Symmetry symmetry) {
  return std::make_unique<SkyTallyFilm>(tally, symmetriesOf(cloud, symmetry), cloud.sun().toCentre());
}

TraceReport traceTally(SkyTally& tally, const Cloud& cloud, const TraceSettings& settings, std::uint64_t firstRay,
                       const TraceControl& control) {
  const auto film = makeFilm(tally, cloud, settings.symmetry);
  TraceReport report = traceRays(cloud, settings, firstRay, *film, control);
  if (report.rays > 0) tally.info().rays = {{report.firstRay, report.rays}};
  tally.shareOrigin();
  return report;
}

}  // namespace parhelion
