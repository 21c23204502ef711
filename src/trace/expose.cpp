// SPDX-License-Identifier: Apache-2.0
#include "trace/expose.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "trace/radial_film.h"
#include "trace/sky_film.h"

namespace parhelion {

Symmetry symmetryOf(const Cloud& cloud, Symmetry asked) {
  if (asked != Symmetry::automatic) return asked;
  if (std::ranges::all_of(cloud.populations(), &Population::isFullyRandom)) return Symmetry::radial;
  const bool mirrored = std::ranges::all_of(cloud.populations(), &Population::isMirrorSymmetric);
  return mirrored ? Symmetry::mirror : Symmetry::none;
}

TallySymmetry countingOf(Symmetry chosen) {
  switch (chosen) {
    case Symmetry::mirror:
      return TallySymmetry::mirror;
    case Symmetry::radial:
      return TallySymmetry::radial;
    case Symmetry::automatic:
    case Symmetry::none:
      break;
  }
  return TallySymmetry::none;
}

std::unique_ptr<Film> makeFilm(Tally& tally, const Cloud& cloud, Symmetry symmetry) {
  tally.info.symmetry = countingOf(symmetryOf(cloud, symmetry));
  if (tally.info.symmetry == TallySymmetry::radial) return std::make_unique<RadialFilm>(tally, cloud.sun().toCentre());
  return std::make_unique<SkyFilm>(tally);
}

TraceReport traceTally(Tally& tally, const Cloud& cloud, const TraceSettings& settings, std::uint64_t firstRay,
                       const TraceControl& control) {
  const auto film = makeFilm(tally, cloud, settings.symmetry);
  TraceReport report = traceRays(cloud, settings, firstRay, *film, control);
  if (report.rays > 0) tally.info.rays = {{report.firstRay, report.rays}};
  return report;
}

}  // namespace parhelion
