// SPDX-License-Identifier: Apache-2.0
#include <cstdio>
#include <filesystem>
#include <optional>

#include "cli/commands.h"
#include "cli/run_options.h"
#include "cli/tally_run.h"
#include "cli/text_output.h"
#include "image/exr.h"
#include "image/png.h"
#include "image/tone.h"
#include "recon/reconstruct.h"
#include "trace/draw_sun.h"

namespace parhelion::cli {

namespace {

struct RenderOptions {
  RunOptions run;
  std::string output;              // of the EXR; empty: the scene's name in the current folder
  std::optional<double> exposure;  // stops

  std::filesystem::path exr() const {
    std::filesystem::path path = output.empty() ? std::filesystem::path(run.scene).filename().string() : output;
    return path.replace_extension(".exr");
  }
  std::filesystem::path png() const { return exr().replace_extension(".png"); }
};

/// Writes the preview and says at which exposure.
void writePreview(const RenderOptions& options, const Image& sky, const ExrAttributes& attributes) {
  const double stops = options.exposure ? *options.exposure : autoExposure(sky);
  const Preview preview = developPreview(sky, {stops});
  char exposure[64];
  std::snprintf(exposure, sizeof exposure, "%+.2f stops", stops);
  writePng(options.png(), preview, {{"Software", attributes.at("software")}, {"Exposure", exposure}});
  if (options.run.quiet) return;
  std::fprintf(stderr, "wrote %s and %s (exposure %s)\n", options.exr().c_str(), options.png().c_str(), exposure);
  if (preview.badPixels > 0)
    std::fprintf(stderr, "%zu pixels are not finite and black in the preview\n", preview.badPixels);
}

int runRender(const RenderOptions& options) {
  const LoadedScene loaded = options.run.load();
  requireWritable(options.exr());
  requireWritable(options.png());
  const Cloud cloud = makeCloud(loaded.scene);
  const TallyRun run = traceTally(options.run, loaded, cloud);

  Image sky = reconstruct(run.tally, loaded.scene.recon);
  if (loaded.scene.sun.visible)
    drawUndeviatedSun(sky, Camera(loaded.scene.camera), cloud.sun(), run.tally.info.undeviatedFraction());
  const ExrAttributes attributes = sceneAttributes(loaded, run.result.report.rays);
  writeBeautyExr(options.exr(), sky, attributes);
  writePreview(options, sky, attributes);
  return run.result.exitCode();
}

}  // namespace

void addRender(CLI::App& app, int& exit) {
  auto options = std::make_shared<RenderOptions>();
  CLI::App* command = app.add_subcommand("render", "Render a scene to a linear EXR and a PNG preview beside it");
  options->run.addTo(*command, true);
  command->add_option("-o,--output", options->output, "The EXR; the PNG has the same name. SCENE.exr when left out")
      ->type_name("FILE");
  command
      ->add_option("--exposure", options->exposure,
                   "Exposure of the preview, stops; chosen by the picture when left out")
      ->type_name("STOPS");
  command->callback([options, &exit] { exit = runRender(*options); });
}

}  // namespace parhelion::cli
