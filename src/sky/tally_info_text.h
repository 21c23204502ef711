// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sky/attribute_text.h"
#include "sky/tally_info.h"

namespace parhelion {

/// Where the sums of a file come from as text attributes, named without "parhelion:".
ExrAttributes textFromOrigin(const TallyOrigin& origin);

/// The inverse. Throws as AttributeReader does, also for ranges of rays that are not in order.
TallyOrigin originFromText(const AttributeReader& attributes);

/// A tally's info as text attributes, all but the picture's size.
ExrAttributes textFromInfo(const TallyInfo& info);

/// The inverse. Throws std::invalid_argument with the attribute, what was found in it and what it should be.
TallyInfo infoFromText(const ExrAttributes& attributes);

}  // namespace parhelion
