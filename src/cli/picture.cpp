// SPDX-License-Identifier: Apache-2.0
#include "cli/picture.h"

#include <cstdio>

#include "cli/run_options.h"
#include "cli/tally_run.h"
#include "image/exr.h"
#include "image/png.h"
#include "image/tone.h"
#include "recon/reconstruct.h"
#include "trace/draw_sun.h"

namespace parhelion::cli {

void PictureOptions::addTo(CLI::App& command) {
  command
      .add_option("-o,--output", output,
                  "The EXR, or its folder; the PNG stands beside it. Named after the input when left out")
      ->type_name("FILE");
  command.add_option("--exposure", exposure, "Exposure of the preview; chosen by the picture when left out")
      ->type_name("STOPS")
      ->check(number(-100.0, 100.0));
}

std::filesystem::path PictureOptions::exr(const std::string& input) const {
  const std::filesystem::path own = std::filesystem::path(input).filename().replace_extension(".exr");
  if (output.empty()) return own;
  std::filesystem::path path = output;
  if (!path.has_filename() || std::filesystem::is_directory(path)) return path / own;
  const std::string extension = path.extension().string();
  if (!extension.empty() && extension != ".exr" && extension != ".png")
    throw CLI::ValidationError("-o", "a picture is an .exr with a .png beside it, not " + output);
  return path.replace_extension(".exr");
}

void writePicture(const Tally& tally, const LoadedScene& loaded, const PictureOptions& options,
                  const std::string& input, bool quiet) {
  Image sky = reconstruct(tally, loaded.scene.recon);
  if (loaded.scene.sun.visible)
    drawUndeviatedSun(sky, Camera(tally.info.camera), Sun(loaded.scene.sun), tally.info.undeviatedFraction());
  const ExrAttributes attributes = sceneAttributes(loaded, tally.info.rayCount());
  const std::filesystem::path exr = options.exr(input), png = options.png(input);
  writeBeautyExr(exr, sky, attributes);

  const double stops = options.exposure ? *options.exposure : autoExposure(sky);
  const Preview preview = developPreview(sky, {stops});
  char exposure[64];
  std::snprintf(exposure, sizeof exposure, "%+.2f stops", stops);
  writePng(png, preview, {{"Software", attributes.at("software")}, {"Exposure", exposure}});
  if (quiet) return;
  std::fprintf(stderr, "wrote %s and %s (exposure %s)\n", exr.c_str(), png.c_str(), exposure);
  if (preview.badPixels > 0)
    std::fprintf(stderr, "%zu pixels are not finite and black in the preview\n", preview.badPixels);
}

}  // namespace parhelion::cli
