// SPDX-License-Identifier: Apache-2.0
#include "cli/scene_input.h"

#include <optional>

#include "cli/file_words.h"

namespace parhelion::cli {

namespace {

/// What messages call it.
std::string shownName(const std::string& name) { return name == "-" ? "stdin" : name; }

}  // namespace

std::string sceneTextOf(const std::string& name) {
  std::string text = readSceneText(name == "-" ? "/dev/stdin" : name);
  if (const std::optional<Misfit> misfit = misfitOf(name, text, Wanted::scene))
    throw SceneError({{shownName(name), 0, 0, misfit->message, misfit->hint, ""}});
  return text;
}

LoadedScene parseSceneOf(const std::string& name, const std::string& text, std::span<const SceneOverride> overrides) {
  return parseScene(text, shownName(name), overrides);
}

LoadedScene loadSceneOf(const std::string& name, std::span<const std::string> overrides) {
  return parseSceneOf(name, sceneTextOf(name), overridesOf({overrides.begin(), overrides.end()}));
}

}  // namespace parhelion::cli
