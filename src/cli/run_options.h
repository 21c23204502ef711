// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

#include "math/names.h"
#include "scene/parse_scene.h"

namespace parhelion::cli {

/// What all commands that trace have in common.
struct RunOptions {
  std::string scene;
  std::vector<std::string> overrides;  // -D key=value
  // Turned into overrides by load(); empty: what the scene says.
  std::string rays, seed, resolution, engine, sampler, symmetry, filter;
  bool noGround = false;                                       // the same
  double timeLimit = std::numeric_limits<double>::infinity();  // s
  int threads = 0;
  std::string simd = "auto";
  bool quiet = false;
  std::string progress = "auto";  // "auto", "json"
  std::string stats;              // file for the run's figures; empty: none
  bool overwrite = false;         // files, too, that parhelion has not written
  bool mayIntegrate = false;      // of commands that can do without rays

  /// Adds the scene argument and the options to a subcommand.
  void addTo(CLI::App& command, bool hasImage);

  /// The same without the scene and the picture's size, for commands that get these in another way.
  void addTracingTo(CLI::App& command, bool hasImage);

  /// The scene with all overrides applied, and then `more`. Throws SceneError, and Unfit for a scene to be integrated
  /// where rays are needed.
  LoadedScene load(const std::vector<std::string>& more = {}) const;

 private:
  mutable std::optional<std::string> sceneText_;  // read once: a pipe gives it only once
};

inline constexpr int kMostThreads = 4096;

/// Adds -D key=value, which overrides a key of the scene, to a subcommand.
void addOverrides(CLI::App& command, std::vector<std::string>& overrides);

// For CLI11's options: checks that say in one line what was expected.

/// A file name with one of the extensions (".png"), in small or capital letters.
CLI::Validator fileOfKind(std::vector<std::string> extensions, std::string expected);

CLI::Validator oneOf(std::vector<std::string_view> accepted);

/// One of the names of a family (math/names.h), with a suggestion where it is nearly one.
template <class Family>
CLI::Validator nameOfOne() {
  return oneOf(acceptedNames<Family>());
}

}  // namespace parhelion::cli
