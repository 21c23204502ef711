// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

namespace parhelion {

/// A time such as 90, 0.5s, 10min, 2h, 3d or 1h30min, in seconds; a number alone is seconds. None for anything else.
std::optional<double> secondsIn(std::string_view text);

}  // namespace parhelion
