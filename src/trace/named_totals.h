// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>

#include "math/exact_sum.h"

namespace parhelion {

/// The totals of a map or a profile by their names in files: counts as such, light in units of ExactSum.
using NamedTotals = std::map<std::string, ExactSum::Units>;

}  // namespace parhelion
