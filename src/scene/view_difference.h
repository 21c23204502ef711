// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

namespace parhelion {

/// What makes the same pixel of two scenes' pictures show different parts of the sky about the sun, with both values:
/// "sun.elevation (20 and 23)", in degrees. The sizes of the pictures do not count, nor does which way the same field
/// of view was given.
std::vector<std::string> differencesOfView(const Scene& one, const Scene& other);

}  // namespace parhelion
