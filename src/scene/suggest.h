// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace parhelion {

/// Insertions, deletions, replacements and swaps of neighbours that turn `a` into `b` (optimal string alignment).
int editDistance(std::string_view a, std::string_view b);

/// "did you mean 'x'?" with the nearest of the accepted names that are within a third of their length, or else with all
/// that begin with the word or have it between their dashes: "did you mean 'fov_horizontal' or 'fov_vertical'?".
/// Nothing where there is none.
std::string didYouMean(std::string_view word, std::span<const std::string_view> accepted);

}  // namespace parhelion
