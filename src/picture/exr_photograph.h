// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "picture/exr.h"
#include "picture/stored_picture.h"

namespace parhelion {

/// Reads a flat scan-line EXR with channels R, G, B or only Y, and A if it has one, as its display window shows it: 0
/// outside of what the file holds. Text attributes go into `text`. Throws std::runtime_error "path: reason".
/// Before it takes memory for the samples, and for the `bytesForUse` of the rules, it asks requireMemoryFor().
StoredPicture readExrPhotograph(const std::filesystem::path& path, const PhotographRules& rules);

}  // namespace parhelion
