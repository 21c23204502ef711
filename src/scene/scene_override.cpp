// SPDX-License-Identifier: Apache-2.0
#include "scene/scene_override.h"

namespace parhelion {

namespace {

/// Any text as a string of TOML, literal where that can be.
std::string tomlString(const std::string& text) {
  if (text.find('\'') == std::string::npos) return '\'' + text + '\'';
  std::string quoted;
  for (const char c : text) quoted += c == '"' || c == '\\' ? std::string("\\") + c : std::string(1, c);
  return '"' + quoted + '"';
}

}  // namespace

std::string SceneOverride::name() const {
  if (option.empty()) return "-D " + text;
  return word.empty() ? option : option + " '" + word + "'";
}

std::size_t SceneOverride::wordAt() const {
  if (option.empty()) return 0;
  const std::size_t value = text.find('=') + 1, found = text.find(word, value);
  // What is written in another way, as 1920x1080 is, still begins behind a quote or a bracket.
  return found != std::string::npos && !word.empty() ? found : text.find_first_not_of("'\"[", value);
}

SceneOverride overrideOf(std::string_view option, const std::string& word, std::string_view key) {
  return overrideOf(option, word, key, tomlString(word));
}

SceneOverride overrideOf(std::string_view option, const std::string& word, std::string_view key,
                         std::string_view toml) {
  return {std::string(key).append("=").append(toml), std::string(option), word};
}

std::vector<SceneOverride> overridesOf(const std::vector<std::string>& texts) {
  std::vector<SceneOverride> overrides;
  for (const std::string& text : texts) overrides.push_back({text});
  return overrides;
}

}  // namespace parhelion
