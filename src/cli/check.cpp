// SPDX-License-Identifier: Apache-2.0

#include "cli/commands.h"
#include "cli/run_options.h"
#include "cli/say.h"
#include "cli/scene_input.h"
#include "math/range.h"

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

/// Looks at every file before it fails, so that one run shows all that is wrong.
int runCheck(const CheckOptions& options) {
  int exit = kDone;
  for (const std::string& path : options.scenes) {
    try {
      const LoadedScene loaded = loadSceneOf(path, options.overrides);
      answer("%s: ok%s", path.c_str(), sunText(loaded.scene.sun).c_str());
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
