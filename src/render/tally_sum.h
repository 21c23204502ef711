// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "picture/transaction.h"
#include "sky/sky_tally.h"
#include "sky/tally_kind.h"

namespace parhelion {

/// The file of a tally, and what messages call it.
struct TallyFile {
  std::filesystem::path file;
  std::string name;
};

/// Tallies that cannot be added: which, and why, in one line.
struct TallyMisfit : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

/// What some tallies are together.
struct TallySet {
  TallyKind kind = TallyKind::sky;
  TallyOrigin origin;  // of the first, with the rays of all
  RayRanges missing;   // of the rays that the scene asks for, or before the last one that there is
};

/// Looks at the headers of at least one file. Throws TallyMisfit where their sums cannot be added, and
/// std::runtime_error "name: reason" where one is no tally or damaged.
TallySet fittingTallies(std::span<const TallyFile> files);

/// The sums of all files, which must fit. It never holds more than two of them. Throws std::runtime_error
/// "name: reason", also where a sum would overflow.
SkyTally sumOfTallies(std::span<const TallyFile> files);

/// Writes the sum of all files, of whatever kind. Throws as sumOfTallies() does.
void writeSumOfTallies(const Output& output, std::span<const TallyFile> files, TallyKind kind);

}  // namespace parhelion
