// SPDX-License-Identifier: Apache-2.0
#include "scene/schema.h"
#include "cli/say.h"

#include "cli/commands.h"

namespace parhelion::cli {

void addSchema(CLI::App& app, int&) {
  CLI::App* command = app.add_subcommand("schema", "Print the JSON Schema of scene files, for editors");
  command->callback([] { answerLines(sceneSchema()); });
}

}  // namespace parhelion::cli
