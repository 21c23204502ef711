// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "view/labels.h"
#include "view/palette.h"

namespace parhelion {

/// Writes which colour is of which crystals into the corner of the picture where least is drawn, and keeps labels off.
/// Nothing where it would take too much of a small picture.
void drawLegend(Canvas& canvas, Labels& labels, const Crowd& crowd, const Camera& camera,
                const std::vector<HaloFamily>& families, const Palette& palette);

}  // namespace parhelion
