// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "render/traced_sky.h"

namespace parhelion::bench {

/// Traces a scene as its own settings say, but every ray for itself, whatever the sky's symmetry.
TracedSky tracePlainly(LoadedScene loaded);

/// The tally of a scene from a file if it is there and of the same scene, else traced and kept there.
Tally keptTally(const std::filesystem::path& path, const LoadedScene& loaded);

}  // namespace parhelion::bench
