// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "scene/scene.h"
#include "scene/scene_error.h"
#include "scene/scene_override.h"

namespace parhelion {

struct LoadedScene {
  Scene scene;
  std::string
      text;  // TOML that alone gives the same scene: the user's own text, or the source with the overrides in it
  std::optional<double> error{};  // that its picture is integrated to, all of it or in part
};

/// The text of a scene, from a file or a pipe: one byte more than parseScene() takes at the most. Throws SceneError
/// where no such file exists, std::runtime_error "path: reason" where it is there and cannot be read.
std::string readSceneText(const std::filesystem::path& path);

/// Reads and validates a scene file. Each override is "key.path=value" ("sun.elevation=25", "population.0.tilt=2",
/// "population.plates.tilt=2"): the value is TOML or, where it is not, a bare string; overrides apply in order.
/// Throws SceneError with all that is wrong, and as readSceneText() does.
LoadedScene loadScene(const std::filesystem::path& path, std::span<const std::string> overrides = {});

/// The same for TOML in memory; `fileName` is what errors call it. UTF-8, with or without a byte order mark.
LoadedScene parseScene(std::string_view text, std::string_view fileName, std::span<const std::string> overrides = {});
LoadedScene parseScene(std::string_view text, std::string_view fileName, std::span<const SceneOverride> overrides);

/// A number of rays as users write it: "100000", "10M", "1.5k", "2e6"; suffixes k, M, G and T.
/// Throws std::invalid_argument with what was expected unless it is a whole number from 1 to kMaxRays.
std::uint64_t parseRayCount(std::string_view text);

}  // namespace parhelion
