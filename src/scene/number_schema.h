// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>

#include "math/range.h"

namespace parhelion {

using Json = nlohmann::ordered_json;

/// The numbers of a range as draft-04 has it: {"type": "number", "minimum": …}.
Json numberSchema(const Range& range);

/// The schema of a list of `least` to `most` such items.
Json listSchema(const Json& items, std::size_t least, std::size_t most);

}  // namespace parhelion
