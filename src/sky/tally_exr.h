// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "picture/transaction.h"
#include "sky/tally.h"

namespace parhelion {

/// Writes a tally so that reading gives it back bit for bit: an EXR with one part for each number of a pixel, its
/// 64-bit integers as two UINT channels `hi` and `lo`, and the info as text attributes of the first part (doubles in
/// the shortest form that reads back exactly). In one piece or not at all. Throws std::runtime_error "path: reason".
void writeTallyExr(const Output& output, const Tally& tally);

/// Throws std::runtime_error "path: reason" for files that are not such a tally, or damaged.
Tally readTallyExr(const std::filesystem::path& path);

}  // namespace parhelion
