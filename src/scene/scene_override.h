// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace parhelion {

/// A key of a scene and what it is to be. What is wrong with it is told in the words that the user wrote: those of -D,
/// or of an option that stands for the key.
struct SceneOverride {
  std::string text;         // "key.path=value": the value is TOML or, where it is not, a bare string
  std::string option = {};  // "--paths"; empty for -D
  std::string word = {};    // what the user gave that option; empty for a flag

  /// What errors call it: "-D key.path=value", "--paths 'word'", "--flag".
  std::string name() const;

  /// Where in the text the user's word begins, a number of bytes; 0 for -D.
  std::size_t wordAt() const;
};

/// What an option sets: a key, to the word itself or to a value in TOML.
SceneOverride overrideOf(std::string_view option, const std::string& word, std::string_view key);
SceneOverride overrideOf(std::string_view option, const std::string& word, std::string_view key, std::string_view toml);

/// Those of -D.
std::vector<SceneOverride> overridesOf(const std::vector<std::string>& texts);

}  // namespace parhelion
