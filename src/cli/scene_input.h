// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "scene/parse_scene.h"

namespace parhelion::cli {

/// The text of a scene as a command line names it: a file, a pipe, or "-" for stdin. Throws as readSceneText() does,
/// and SceneError for what is no text, with what it is and which command wants it.
std::string sceneTextOf(const std::string& name);

/// The scene of that text, which sceneTextOf() has read from `name`. Throws SceneError.
LoadedScene parseSceneOf(const std::string& name, const std::string& text,
                         std::span<const SceneOverride> overrides = {});

/// Both at once.
LoadedScene loadSceneOf(const std::string& name, std::span<const std::string> overrides = {});

}  // namespace parhelion::cli
