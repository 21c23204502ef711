// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "recon/hit_map.h"
#include "recon/recon_settings.h"
#include "recon/watch.h"

namespace parhelion {

/// One low-pass filter over all pixels, the empty ones as 0: a density. Each iteration then corrects at the pixels hit
/// alone, which have more than the mean, and so brightens the picture; see allebach.h for when that is stopped.
/// Marvasti, Analoui & Gamshadzahi, Recovery of signals from nonuniform samples using iterative methods, 1991.
Reconstruction marvasti(const HitMap& map, const MarvastiSettings& settings, const Watch& watch);

}  // namespace parhelion
