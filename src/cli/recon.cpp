// SPDX-License-Identifier: Apache-2.0
#include "cli/commands.h"
#include "cli/picture.h"
#include "cli/run_options.h"
#include "cli/text_output.h"
#include "image/tally_exr.h"

namespace parhelion::cli {

namespace {

struct ReconOptions {
  std::string tally, method;
  PictureOptions picture;
  bool quiet = false;
};

int runRecon(const ReconOptions& options) {
  const Tally tally = readTallyExr(options.tally);
  std::vector<std::string> overrides;
  if (!options.method.empty()) overrides.push_back("recon.method='" + options.method + "'");
  const LoadedScene loaded = parseScene(tally.info.scene, "the scene in " + options.tally, overrides);
  // A tally is an EXR, too: the picture's name must differ.
  const std::string name = std::filesystem::path(options.tally).stem().string() + "-sky";
  requireOutputs(options.tally, {options.picture.exr(name), options.picture.png(name)});
  writePicture(tally, loaded, options.picture, name, options.quiet);
  return kDone;
}

}  // namespace

void addRecon(CLI::App& app, int& exit) {
  auto options = std::make_shared<ReconOptions>();
  CLI::App* command =
      app.add_subcommand("recon", "Turn a tally from disk into a linear EXR and a PNG preview beside it");
  command->add_option("tally", options->tally, "A tally that trace has written")->required()->type_name("TALLY");
  command->add_option("--method", options->method, "How hits become an image; as the scene says when left out")
      ->type_name("NAME")
      ->check(nameOfOne<ReconMethod>(kReconMethodNames));
  command->add_flag("--quiet", options->quiet, "Nothing on stderr");
  options->picture.addTo(*command);
  command->callback([options, &exit] { exit = runRecon(*options); });
}

}  // namespace parhelion::cli
