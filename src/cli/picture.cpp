// SPDX-License-Identifier: Apache-2.0
#include "cli/picture.h"

#include <cstdio>

#include "cli/run_options.h"
#include "cli/tally_run.h"
#include "picture/exr.h"
#include "picture/png.h"
#include "picture/tone.h"
#include "sky/camera.h"
#include "sky/draw_sun.h"
#include "sky/envmap.h"
#include "sky/radiance.h"

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

void writeSky(const std::filesystem::path& exr, Image& image, const TallyInfo& info, const LoadedScene& loaded) {
  const Camera camera(info.camera);
  if (loaded.scene.sun.visible) drawUndeviatedSun(image, camera, Sun(loaded.scene.sun), info.undeviatedFraction());
  const Envmap envmap = envmapOf(camera);
  // Blender takes a channel with a dot in its name for the sign of several layers, which it lights nothing with.
  if (envmap == Envmap::latLong)
    std::erase_if(image.channels, [](const Channel& channel) { return channel.name == kVarianceChannel; });
  writeBeautyExr(exr, image, sceneAttributes(loaded, info.rayCount()), envmap);
}

std::string exposureText(double stops) {
  char text[64];
  std::snprintf(text, sizeof text, "%+.2f stops", stops);
  return text;
}

void writePreview(const std::filesystem::path& png, const Preview& preview, double stops) {
  writePng(png, preview, {{"Software", "parhelion " PARHELION_VERSION}, {"Exposure", exposureText(stops)}});
}

void writePicture(ReconstructedSky sky, const TallyInfo& info, const LoadedScene& loaded, const PictureOptions& options,
                  const std::string& input, bool quiet) {
  const std::filesystem::path exr = options.exr(input), png = options.png(input);
  writeSky(exr, sky.image, info, loaded);
  const double stops = options.exposure ? *options.exposure : autoExposure(sky.image);
  const Preview preview = developPreview(sky.image, {stops});
  writePreview(png, preview, stops);
  if (quiet) return;
  for (const std::string& remark : sky.remarks) std::fprintf(stderr, "recon: %s\n", remark.c_str());
  std::fprintf(stderr, "wrote %s and %s (exposure %s)\n", exr.c_str(), png.c_str(), exposureText(stops).c_str());
  if (preview.badPixels > 0)
    std::fprintf(stderr, "%zu pixels are not finite and black in the preview\n", preview.badPixels);
}

}  // namespace parhelion::cli
