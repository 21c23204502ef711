// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "math/checksum.h"
#include "picture/exr.h"

namespace parhelion {

/// What our attributes begin with.
inline constexpr std::string_view kOurPrefix = "parhelion:";

/// The attribute that holds the checksum of a header's meaning.
inline constexpr const char* kChecksumKey = "parhelion:checksum";

/// Adds to a checksum what attributes mean that are ours. In ascending order of their bytes, of each there are: its
/// name, a space, the number of its bytes, a line feed, its bytes, a line feed. The checksum itself is left out.
inline void addMeaning(Checksum& checksum, const ExrAttributes& attributes) {
  for (const auto& [name, value] : attributes) {
    if (!name.starts_with(kOurPrefix) || name == kChecksumKey) continue;
    checksum.add(name + " " + std::to_string(value.size()) + "\n" + value + "\n");
  }
}

}  // namespace parhelion
