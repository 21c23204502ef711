// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace parhelion {

/// A key of the scene and the values it takes, one after the other, as text for an override "key=value".
struct KeyRange {
  std::string key;
  std::vector<std::string> values;
};

/// Most frames of a sweep: above an hour of film at 25 a second.
inline constexpr std::size_t kMaxFrames = 100'000;

/// Reads "key=from:to:step" or "key=a,b,c" (one value will do). Value i of a range is from + i step, so that no error
/// adds up, written with at most 12 digits, whole numbers with all of theirs; `to` is among the values if the steps
/// reach it. The same for dates, whose step is a time such as 10min and whose offset from UTC is that of `from`. Throws std::invalid_argument in one line that quotes `text`.
KeyRange parseKeyRange(std::string_view text);

/// The overrides of each frame: the keys go together value by value, or in all combinations, the last key fastest.
/// Throws std::invalid_argument if a key comes twice, or the numbers of values differ where the keys go together.
std::vector<std::vector<std::string>> sweepFrames(std::span<const KeyRange> ranges, bool product);

}  // namespace parhelion
