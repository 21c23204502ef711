// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "picture/exr.h"
#include "sky/tally.h"

namespace parhelion {

/// A tally's info as text attributes, all but the picture's size; doubles in the shortest form that reads back exactly.
ExrAttributes textFromInfo(const TallyInfo& info);

/// The inverse. Throws std::invalid_argument if an attribute is missing or makes no sense.
TallyInfo infoFromText(const ExrAttributes& attributes);

}  // namespace parhelion
