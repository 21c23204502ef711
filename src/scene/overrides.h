// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <toml++/toml.h>

#include "scene/complaints.h"
#include "scene/scene_override.h"

namespace parhelion {

/// Applies an override to the scene. A number in the path picks an element of a list, counting from 0; a
/// population can be picked by its name too. "key.path=" takes the key out of the scene. What cannot be applied is
/// complained about.
void applyOverride(toml::table& scene, const SceneOverride& override, Complaints& complaints);

}  // namespace parhelion
