// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>

#include "math/range.h"

namespace parhelion {

using Json = nlohmann::ordered_json;

/// The numbers of a range as draft-04 has it: {"type": "number", "minimum": …}.
Json numberSchema(const Range& range);

}  // namespace parhelion
