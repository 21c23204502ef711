// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace parhelion::cli {

/// What a command takes a file for: a photograph is a picture of any kind, a sky an EXR, and a view can be of a
/// photograph or a tally.
enum class Wanted { scene, tally, photograph, sky, view };

/// Why a file cannot be what a command takes it for.
struct Misfit {
  std::string message;  // "is a tally, not a scene"
  std::string hint;     // which command wants it; may be empty
};

/// None if a file that begins with these bytes may be what is wanted: only its reader knows for sure.
std::optional<Misfit> misfitOf(const std::filesystem::path& path, std::string_view start, Wanted wanted);

/// Throws Unfit "path: what it is: which command wants it" if the file cannot be what is wanted.
void requireFit(const std::filesystem::path& path, Wanted wanted);

}  // namespace parhelion::cli
