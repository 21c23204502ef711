// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "sky/attribute_text.h"
#include "sky/tally_info.h"

namespace parhelion {

/// Where the sums of a file come from as text attributes, named without "parhelion:".
ExrAttributes textFromOrigin(const TallyOrigin& origin);

/// The inverse. Throws as AttributeReader does, also for ranges of rays that are not in order.
TallyOrigin originFromText(const AttributeReader& attributes);

/// A tally's info as text attributes, all but the picture's size.
ExrAttributes textFromInfo(const TallyInfo& info);

// What the parts of a tally are (sky/sky_tally.h): the attribute "symmetry" as a list, and one attribute for each layer
// that has a name. The inverses throw as infoFromText() does.
std::string textFromSymmetries(const std::vector<TallySymmetry>& symmetries);
std::vector<TallySymmetry> symmetriesFromText(const ExrAttributes& attributes);
std::string layerKey(std::size_t layer);
std::vector<std::string> layersFromText(const ExrAttributes& attributes);

/// The inverse of textFromInfo(), with the first symmetry. Throws std::invalid_argument with the attribute, what was
/// found in it and what it should be.
TallyInfo infoFromText(const ExrAttributes& attributes);

}  // namespace parhelion
