// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string_view>

namespace parhelion {

/// Of what a file holds the exact sums.
enum class TallyKind { sky, map, profile };

constexpr std::string_view nameOf(TallyKind value) {
  switch (value) {
    case TallyKind::sky:
      return "sky";
    case TallyKind::map:
      return "map";
    case TallyKind::profile:
      return "profile";
  }
  return {};
}

class AttributeReader;
class SumsExr;

/// The kind of a tally by its attributes. Throws as AttributeReader does.
TallyKind tallyKindOf(const AttributeReader& attributes);

/// Throws std::runtime_error "path: is the tally of a map, not of a sky" unless a file is of a kind.
void requireTallyKind(const std::filesystem::path& path, const SumsExr& file, TallyKind kind);

/// The kind of a file. Throws std::runtime_error "path: reason" where it is no tally, or its header is damaged.
TallyKind tallyKindOf(const std::filesystem::path& path);

}  // namespace parhelion
