// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "picture/transaction.h"
#include "sky/sky_tally.h"

namespace parhelion {

/// Writes a tally so that reading gives it back bit for bit: a file of sums (sky/sums_exr.h) with one part for each
/// number of a pixel and, of a radial sky, one for each number of a ring, and the info as text attributes. Where the
/// tally has several parts, the names of theirs begin with the layer and the symmetry. In one piece or not at all.
/// Throws std::runtime_error "path: reason".
void writeSkyTallyExr(const Output& output, const SkyTally& tally);

/// The same of a tally of one part.
void writeTallyExr(const Output& output, const Tally& tally);

/// Throws std::runtime_error "path: reason" for files that are not such a tally, are damaged, or hold what no run can
/// have made (sky/tally_checks.h).
SkyTally readSkyTallyExr(const std::filesystem::path& path);

/// The same as one plain tally (SkyTally::flattened()).
Tally readTallyExr(const std::filesystem::path& path);

/// Its info alone, of the first part, after a look at the header only.
TallyInfo readTallyInfo(const std::filesystem::path& path);

}  // namespace parhelion
