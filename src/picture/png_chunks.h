// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>
#include <set>
#include <string>

namespace parhelion {

/// The chunks of a PNG, looked at before libpng does, which would allocate what a lying length promises.
struct PngChunks {
  bool whole = false;           // all of them end within the file, the last being IEND
  std::set<std::string> large;  // kinds of which one is larger than kMostPngChunk (limits.h) or than the file, "tEXt"
};

/// Goes through a file from its start, and back to there.
PngChunks walkPng(std::FILE* file);

}  // namespace parhelion
