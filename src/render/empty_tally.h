// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "scene/parse_scene.h"
#include "sky/tally.h"
#include "trace/cloud.h"

namespace parhelion {

/// A tally of a scene's camera with all that is known before its rays are traced by this version of the program.
/// `cloud` is the scene's.
Tally emptyTally(const LoadedScene& loaded, const Cloud& cloud, const std::string& version);

}  // namespace parhelion
