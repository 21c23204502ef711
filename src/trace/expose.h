// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sky/tally.h"
#include "trace/cloud.h"
#include "trace/film.h"
#include "trace/trace.h"

namespace parhelion {

/// The symmetry asked for, or the most that the cloud allows where the choice is left.
Symmetry symmetryOf(const Cloud& cloud, Symmetry asked);

/// What rays count for in tallies when a chosen symmetry is made use of.
TallySymmetry countingOf(Symmetry chosen);

/// What exposes a tally, making use of a symmetry that the cloud must have, which the tally's info then names. `tally`
/// must be empty and outlive the film, which is good for one run of traceRays(): when that is done the tally is
/// complete.
std::unique_ptr<Film> makeFilm(Tally& tally, const Cloud& cloud, Symmetry symmetry);

/// Traces rays firstRay ... settings.rays - 1 into an empty tally through its own camera, making use of the settings'
/// symmetry, and notes in its info which rays those were. As traceRays() otherwise.
TraceReport traceTally(Tally& tally, const Cloud& cloud, const TraceSettings& settings, std::uint64_t firstRay = 0,
                       const TraceControl& control = {});

}  // namespace parhelion
