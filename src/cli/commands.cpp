// SPDX-License-Identifier: Apache-2.0
#include "cli/commands.h"

#include "cli/memory_option.h"

namespace parhelion::cli {

namespace {

/// No value of any option is empty: no number, no name, and no file.
void requireValues(CLI::App& app) {
  const CLI::Validator notEmpty(
      [](const std::string& value) { return value.empty() ? "expected a value, not ''" : std::string(); }, "");
  for (CLI::App* command : app.get_subcommands({}))
    for (CLI::Option* option : command->get_options())
      if (option->get_items_expected_max() > 0) option->check(notEmpty);
}

}  // namespace

void addCommands(CLI::App& app, int& exit, Tracers& tracers) {
  addRender(app, exit, tracers);
  addTrace(app, exit, tracers);
  addRecon(app, exit);
  addMerge(app, exit);
  addComposite(app, exit);
  addSweep(app, exit);
  addView(app, exit);
  addProfile(app, exit, tracers);
  addMap(app, exit, tracers);
  addPaths(app, exit);
  addReplay(app, exit);
  addInfo(app, exit);
  addCheck(app, exit);
  for (CLI::App* command : app.get_subcommands({})) addMemory(*command);
  addSchema(app, exit);  // which reads nothing
  requireValues(app);
}

}  // namespace parhelion::cli
