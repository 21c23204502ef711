// SPDX-License-Identifier: Apache-2.0
#include "cli/commands.h"

#include "cli/memory_option.h"

namespace parhelion::cli {

void addCommands(CLI::App& app, int& exit, Tracers& tracers) {
  addRender(app, exit, tracers);
  addTrace(app, exit, tracers);
  addRecon(app, exit);
  addComposite(app, exit);
  addSweep(app, exit);
  addView(app, exit);
  addProfile(app, exit, tracers);
  addMap(app, exit, tracers);
  addReplay(app, exit);
  addInfo(app, exit);
  addCheck(app, exit);
  for (CLI::App* command : app.get_subcommands({})) addMemory(*command);
  addSchema(app, exit);  // which reads nothing
}

}  // namespace parhelion::cli
