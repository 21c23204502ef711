// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <toml++/toml.h>

#include "scene/complaints.h"
#include "scene/scene.h"

namespace parhelion {

/// Complains about absorption and diffraction of crystals of unknown size, about absorption that is not known, and
/// about sizes that change nothing.
void checkOptics(const toml::table& root, const Scene& scene, Complaints& complaints);

}  // namespace parhelion
