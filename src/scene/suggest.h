// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace parhelion {

/// Insertions, deletions, replacements and swaps of neighbours that turn `a` into `b` (optimal string alignment).
int editDistance(std::string_view a, std::string_view b);

/// "did you mean 'x'?", or nothing where no accepted name is within a third of its length.
std::string didYouMean(std::string_view word, std::span<const std::string_view> accepted);

}  // namespace parhelion
