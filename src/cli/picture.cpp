// SPDX-License-Identifier: Apache-2.0
#include "cli/picture.h"

#include <cstdio>

#include "cli/run_options.h"
#include "cli/tally_run.h"
#include "image/exr.h"
#include "image/png.h"
#include "image/tone.h"
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
  if (output == "-") throw CLI::ValidationError("-o", "a picture is two files and cannot go to stdout");
  std::filesystem::path path = output;
  if (!path.has_filename() || std::filesystem::is_directory(path)) return path / own;
  const std::string extension = path.extension().string();
  if (!extension.empty() && extension != ".exr" && extension != ".png")
    throw CLI::ValidationError("-o", "a picture is an .exr with a .png beside it, not " + output);
  return path.replace_extension(".exr");
}

void writePicture(ReconstructedSky sky, const TallyInfo& info, const LoadedScene& loaded, const PictureOptions& options,
                  const std::string& input, bool quiet) {
  Image& image = sky.image;
  if (loaded.scene.sun.visible)
    drawUndeviatedSun(image, Camera(info.camera), Sun(loaded.scene.sun), info.undeviatedFraction());
  const ExrAttributes attributes = sceneAttributes(loaded, info.rayCount());
  const std::filesystem::path exr = options.exr(input), png = options.png(input);
  writeBeautyExr(exr, image, attributes);

  const double stops = options.exposure ? *options.exposure : autoExposure(image);
  const Preview preview = developPreview(image, {stops});
  char exposure[64];
  std::snprintf(exposure, sizeof exposure, "%+.2f stops", stops);
  writePng(png, preview, {{"Software", attributes.at("software")}, {"Exposure", exposure}});
  if (quiet) return;
  for (const std::string& remark : sky.remarks) std::fprintf(stderr, "recon: %s\n", remark.c_str());
  std::fprintf(stderr, "wrote %s and %s (exposure %s)\n", exr.c_str(), png.c_str(), exposure);
  if (preview.badPixels > 0)
    std::fprintf(stderr, "%zu pixels are not finite and black in the preview\n", preview.badPixels);
}

}  // namespace parhelion::cli
