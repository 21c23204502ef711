// SPDX-License-Identifier: Apache-2.0

#include <optional>
#include <stdexcept>

#include "cli/commands.h"
#include "cli/run_options.h"
#include "cli/say.h"
#include "cli/scene_input.h"
#include "math/range.h"
#include "render/integrated_paths.h"
#include "render/integrated_profile.h"
#include "render/integrated_sky.h"
#include "render/traced_sky.h"

namespace parhelion::cli {

namespace {

struct CheckOptions {
  std::vector<std::string> scenes;
  std::vector<std::string> overrides;
};

/// ", the sun at elevation 12.3456 and azimuth 140.1 from north" where the scene tells both; else empty.
std::string sunText(const SunSettings& sun) {
  if (!sun.azimuth) return {};
  return ", the sun at elevation " + formatNumber(degrees(sun.elevation)) + "° and azimuth " +
         formatNumber(degrees(*sun.azimuth)) + "° from north";
}

/// Which commands would refuse to begin with a scene that is right in itself, and why.
struct Refusal {
  std::string commands, reason;
  bool isOfAll = false;  // none is left that would do it
};

std::optional<Refusal> refusalByEngine(const Scene& scene) {
  if (scene.trace.engine != Engine::integral) return std::nullopt;
  Refusal refusal{{}, {}, true};
  const auto ask = [&](const char* commands, const std::string& objection) {
    refusal.isOfAll = refusal.isOfAll && !objection.empty();
    if (objection.empty()) return;
    refusal.commands += (refusal.commands.empty() ? "" : ", ") + std::string(commands);
    if (refusal.reason.empty()) refusal.reason = objection;
  };
  ask("render, sweep, map", objectionToIntegratedSky(scene));
  ask("profile", objectionToIntegral(scene));
  ask("paths", objectionToIntegratedPaths(scene));
  if (refusal.commands.empty()) return std::nullopt;
  refusal.reason = "engine integral: " + refusal.reason + "; rays can do it, with another engine, such as auto";
  return refusal;
}

std::optional<Refusal> refusalByPaths(const Scene& scene) {
  if (scene.trace.paths.layers.empty() && !scene.trace.paths.filter) return std::nullopt;
  try {
    const Cloud cloud = cloudOf(scene);
    const PathPlan plan(cloud, scene.trace.paths);
  } catch (const std::invalid_argument& error) {
    return Refusal{"all commands", error.what(), true};
  }
  return std::nullopt;
}

/// Looks at every file before it fails, so that one run shows all that is wrong.
int runCheck(const CheckOptions& options) {
  int exit = kDone;
  for (const std::string& path : options.scenes) {
    try {
      const LoadedScene loaded = loadSceneOf(path, options.overrides);
      auto refusal = refusalByPaths(loaded.scene);
      if (!refusal) refusal = refusalByEngine(loaded.scene);
      if (!refusal) {
        answer("%s: ok%s", path.c_str(), sunText(loaded.scene.sun).c_str());
      } else if (!refusal->isOfAll) {
        answer("%s: ok%s, but refused by %s: %s", path.c_str(), sunText(loaded.scene.sun).c_str(),
               refusal->commands.c_str(), refusal->reason.c_str());
      } else {
        sayLines(path + ": error: " + refusal->reason + "\n");
        exit = kUsageError;
      }
    } catch (const SceneError& error) {
      sayLines(std::string(error.what()) + "\n");
      exit = kUsageError;
    }
  }
  return exit;
}

}  // namespace

void addCheck(CLI::App& app, int& exit) {
  auto options = std::make_shared<CheckOptions>();
  CLI::App* command = app.add_subcommand("check", "Validate scene files; traces nothing");
  command->add_option("scene", options->scenes, "Scene files")->required()->type_name("SCENE");
  addOverrides(*command, options->overrides);
  command->callback([options, &exit] { exit = runCheck(*options); });
}

}  // namespace parhelion::cli
