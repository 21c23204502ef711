// SPDX-License-Identifier: Apache-2.0
#include "cli/commands.h"
#include "cli/outputs.h"
#include "cli/say.h"
#include "cli/tally_input.h"

namespace parhelion::cli {

namespace {

struct MergeOptions {
  std::vector<std::string> tallies;
  std::string output;
  bool complete = false, overwrite = false, quiet = false;
};

int runMerge(const MergeOptions& options) {
  Transaction outputs = claimOutputs({options.tallies, {options.output}}, options.overwrite);
  const TallyInputs inputs(options.tallies);
  const TallySet set = requireFitting(inputs);
  reportMissing(set, options.complete, options.quiet);
  writeSumOfTallies(outputs.at(options.output), inputs.files(), set.kind);
  outputs.commit();
  if (!options.quiet) say("wrote %s: %s", options.output.c_str(), wordsFor(set.origin.rays).c_str());
  return kDone;
}

}  // namespace

void addMerge(CLI::App& app, int& exit) {
  auto options = std::make_shared<MergeOptions>();
  CLI::App* command =
      app.add_subcommand("merge", "Add up tallies of different rays of one scene, exactly, in any order");
  command
      ->add_option("tallies", options->tallies,
                   "Tallies that trace, map or profile has written, all of one scene and kind; - for stdin")
      ->required()
      ->type_name("TALLY");
  command->add_option("-o,--output", options->output, "The tally of all their rays, an EXR; - for stdout")
      ->type_name("FILE")
      ->required();
  command->add_flag("--complete", options->complete, "Fail where rays of the scene are in none of them");
  addOverwrite(*command, options->overwrite);
  command->add_flag("--quiet", options->quiet, "Nothing on stderr but errors");
  command->callback([options, &exit] { exit = runMerge(*options); });
}

}  // namespace parhelion::cli
