// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "picture/transaction.h"
#include "sky/tally.h"

namespace parhelion {

/// Writes a tally so that reading gives it back bit for bit: a file of sums (sky/sums_exr.h) with one part for each
/// number of a pixel and, of a radial sky, one for each number of a ring, and the info as text attributes. In one piece
/// or not at all. Throws std::runtime_error "path: reason".
void writeTallyExr(const Output& output, const Tally& tally);

/// Throws std::runtime_error "path: reason" for files that are not such a tally, are damaged, or hold what no run can
/// have made (sky/tally_checks.h).
Tally readTallyExr(const std::filesystem::path& path);

/// Its info alone, after a look at the header only.
TallyInfo readTallyInfo(const std::filesystem::path& path);

}  // namespace parhelion
