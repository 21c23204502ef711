// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "sky/sky_tally.h"
#include "trace/cloud.h"
#include "trace/film.h"
#include "trace/trace.h"

namespace parhelion {

/// What the rays of each population count for. Where the choice is left, each population has the most that it allows.
std::vector<TallySymmetry> symmetriesOf(const Cloud& cloud, Symmetry asked);

/// The symmetry asked for. Where the choice is left, the one that all populations have by themselves, or `automatic`
/// where they differ.
Symmetry symmetryOf(const Cloud& cloud, Symmetry asked);

/// The different ones of a list, in the order of TallySymmetry.
std::vector<TallySymmetry> different(std::vector<TallySymmetry> symmetries);

/// What exposes a tally, which must have the symmetries of symmetriesOf(), be empty and outlive the film. It is good
/// for one run of traceRays(): when that is done the tally is complete.
std::unique_ptr<Film> makeFilm(SkyTally& tally, const Cloud& cloud, Symmetry symmetry);

/// Traces rays firstRay ... settings.rays - 1 into an empty tally through its own camera, making use of the settings'
/// symmetry, and notes in its info which rays those were. As traceRays() otherwise.
TraceReport traceTally(SkyTally& tally, const Cloud& cloud, const TraceSettings& settings, std::uint64_t firstRay = 0,
                       const TraceControl& control = {});

}  // namespace parhelion
