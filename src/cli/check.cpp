// SPDX-License-Identifier: Apache-2.0

#include "cli/commands.h"
#include "cli/run_options.h"
#include "cli/say.h"
#include "cli/scene_input.h"

namespace parhelion::cli {

namespace {

struct CheckOptions {
  std::vector<std::string> scenes;
  std::vector<std::string> overrides;
};

/// Looks at every file before it fails, so that one run shows all that is wrong.
int runCheck(const CheckOptions& options) {
  int exit = kDone;
  for (const std::string& path : options.scenes) {
    try {
      loadSceneOf(path, options.overrides);
      answer("%s: ok", path.c_str());
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
