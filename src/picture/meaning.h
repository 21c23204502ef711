// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "math/checksum.h"
#include "picture/exr.h"

namespace parhelion {

/// What our attributes begin with.
inline constexpr std::string_view kOurPrefix = "parhelion:";

/// The attribute that holds the checksum of a header's meaning.
inline constexpr const char* kChecksumKey = "parhelion:checksum";

/// The attribute by which a picture says that it has such a checksum: without that it is damaged.
inline constexpr const char* kPictureKey = "parhelion:picture";
inline constexpr char kPictureFormat = '1';  // which checksum

/// What is left without these two, which are of the file and not of what it shows.
inline ExrAttributes withoutMarks(ExrAttributes attributes) {
  attributes.erase(kChecksumKey);
  attributes.erase(kPictureKey);
  return attributes;
}

/// Adds to a checksum what attributes mean that are ours. In ascending order of their bytes, of each there are: its
/// name, a space, the number of its bytes, a line feed, its bytes, a line feed. The checksum itself is left out.
inline void addMeaning(Checksum& checksum, const ExrAttributes& attributes) {
  for (const auto& [name, value] : attributes) {
    if (!name.starts_with(kOurPrefix) || name == kChecksumKey) continue;
    checksum.add(name + " " + std::to_string(value.size()) + "\n" + value + "\n");
  }
}

}  // namespace parhelion
