// SPDX-License-Identifier: Apache-2.0
#include "cli/commands.h"

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
  addSchema(app, exit);
}

}  // namespace parhelion::cli
