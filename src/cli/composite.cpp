// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>

#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "cli/file_words.h"
#include "cli/halo_options.h"
#include "cli/number_options.h"
#include "cli/outputs.h"
#include "cli/photo_options.h"
#include "cli/say.h"
#include "cli/stats.h"
#include "parallel/threads.h"
#include "photo/found_mask.h"
#include "photo/sky_match.h"
#include "picture/memory_limit.h"
#include "render/composite.h"
#include "render/needs.h"

namespace parhelion::cli {

namespace {

struct CompositeOptions {
  std::string photo, output, mask, maskOutput, layers, white = "sun";
  HaloOptions halo;
  PhotoOptions camera;
  std::optional<double> strength, contrast;
  bool allSky = false;

  bool findsSky() const { return mask.empty() && !allSky; }
  std::filesystem::path foundMask() const {
    if (!maskOutput.empty()) return maskOutput;
    const std::filesystem::path out = output;
    return out.parent_path() / (out.stem().string() + "-mask.png");
  }
};

/// "1,0.9,0.8", positive; none where it is anything else.
std::optional<Vec3> colour(const std::string& text) {
  const std::vector<double> rgb = numbersIn(text, ",,");
  if (rgb.empty() || !(rgb[0] > 0.0 && rgb[1] > 0.0 && rgb[2] > 0.0)) return std::nullopt;
  return Vec3(rgb[0], rgb[1], rgb[2]);
}

std::string validWhite(const std::string& text) {
  if (text == "sun" || text == "sky" || colour(text)) return {};
  return expectedNot("sun, sky or R,G,B (positive numbers)", text);
}

void requireSense(const CompositeOptions& options) {
  options.halo.requireOne();
  if (options.strength && options.contrast) throw CLI::ValidationError("--strength and --contrast exclude each other");
  if (options.allSky && !options.mask.empty()) throw CLI::ValidationError("--mask and --all-sky exclude each other");
  if (!options.maskOutput.empty() && !options.findsSky())
    throw CLI::ValidationError("--mask-out is for a mask that is found; --mask or --all-sky say it already");
}

Transaction claimAll(const CompositeOptions& options) {
  Files files{{options.photo, options.mask, options.halo.file()}, {options.output, options.halo.run.stats}};
  if (options.findsSky()) files.outputs.push_back(options.foundMask());
  if (options.findsSky() && !options.halo.run.overwrite) requireUnchangedMask(options.foundMask());
  if (!options.layers.empty()) files.folders.push_back(options.layers);
  for (const std::filesystem::path& layer : editingFiles(options.layers)) files.outputs.push_back(layer);
  return claimOutputs(files, options.halo.run.overwrite);
}

SkyMask maskOf(const CompositeOptions& options, const Photograph& photograph, const PhotoCamera& camera) {
  if (options.allSky) return allSky(photograph);
  if (options.mask.empty()) return findSkyAbove(photograph, camera.camera, options.halo.run.threads);
  return readSkyMaskOf(photograph, options.mask);
}

HaloStrengthSettings strengthSettings(const CompositeOptions& options) {
  HaloStrengthSettings settings;
  settings.strength = options.strength;
  if (options.contrast) settings.contrast = *options.contrast;
  if (options.white != "sun") settings.white = options.white == "sky" ? std::nullopt : colour(options.white);
  return settings;
}

void sayAll(const std::vector<std::string>& remarks, bool quiet) {
  if (quiet) return;
  for (const std::string& remark : remarks) say("%s", remark.c_str());
}

void report(const CompositeOptions& options, double pixels, const AddedHaloReport& done) {
  const auto share = [pixels](const char* format, std::size_t count) {
    char text[100];
    std::snprintf(text, sizeof text, format, 100.0 * static_cast<double>(count) / pixels);
    return count > 0 ? std::string(text) : std::string();
  };
  say("the halo touches %.1f %% of the picture%s%s", 100.0 * static_cast<double>(done.touched) / pixels,
      share(", %.2f %% becomes whiter than white and is clipped", done.clipped).c_str(),
      share("; %.1f %% is sky that the halo's picture does not reach", done.uncovered).c_str());
  if (options.findsSky())
    say("wrote %s and the sky found in it, %s (correct it and give it back with --mask)", options.output.c_str(),
        options.foundMask().c_str());
  else
    say("wrote %s", options.output.c_str());
}

int runComposite(const CompositeOptions& options) {
  requireSense(options);
  Transaction outputs = claimAll(options);
  const bool quiet = options.halo.run.quiet;
  requireFit(options.photo, Wanted::photograph);
  if (!options.mask.empty()) requireFit(options.mask, Wanted::photograph);
  Photograph photograph = readPhotograph(options.photo, options.camera.rules(kCompositeBytes));
  const PhotoCamera camera = options.camera.camera(photograph, options.photo, options.halo.sunElevation());
  sayAll(camera.remarks, quiet);

  requireMemory(options.photo + ":", memoryToComposite(photograph.pixels(), options.halo.memoryFor(camera)));
  const SkyMask mask = maskOf(options, photograph, camera);
  const MadeHalo made = options.halo.make(camera, options.camera.rules(0).editedPictures());
  const PhotoHalo& halo = made.halo;
  const HaloStrength strength =
      haloStrength(strengthSettings(options), photograph, mask, camera.camera, camera.sunElevation, halo.lookup);
  sayAll(strength.remarks, quiet);

  CompositeFiles files{options.photo, options.output, options.layers, {}, &outputs};
  if (options.findsSky()) files.foundMask = options.foundMask();
  const double pixels = static_cast<double>(photograph.pixels());
  const AddedHaloReport done = writeComposite(files, std::move(photograph), {halo.lookup, mask, strength.perRadiance},
                                              camera, halo.attributes, options.halo.run.threads);
  const std::string& stats = options.halo.run.stats;
  if (!stats.empty() && made.figures) writeJson(outputs.at(stats), statsJson(*made.figures));
  outputs.commit();
  if (!quiet) report(options, pixels, done);
  return kDone;
}

}  // namespace

void addComposite(CLI::App& app, int& exit) {
  auto options = std::make_shared<CompositeOptions>();
  CLI::App* command = app.add_subcommand("composite", "Set a halo into a photograph, as light in its sky");
  command->add_option("photo", options->photo, "The photograph: JPEG, PNG or EXR")->required()->type_name("PHOTO");
  command->add_option("-o,--output", options->output, "The picture to write: .png, .jpg or .exr")
      ->required()
      ->type_name("FILE")
      ->check(fileOfKind({".png", ".jpg", ".jpeg", ".exr"}, ".png, .jpg or .exr"));
  options->halo.addTo(*command);
  command->add_option("--mask", options->mask, "Where the sky is: a PNG, white for sky; found when left out")
      ->type_name("FILE");
  command->add_option("--mask-out", options->maskOutput, "Where to write the mask that was found; beside the output")
      ->type_name("FILE.png")
      ->check(fileOfKind({".png"}, ".png"));
  command->add_flag("--all-sky", options->allSky, "Take all of the picture for sky");
  command->add_option("--strength", options->strength, "Linear samples per radiance (1/sr) of the halo")
      ->type_name("FACTOR")
      ->transform(number(0.0, 1e12));
  command
      ->add_option("--contrast", options->contrast,
                   "Instead: luminance of the halo's bright parts over that of the sky around the sun; 0.5")
      ->type_name("SHARE")
      ->transform(number(0.0, 1e6));
  command
      ->add_option("--white", options->white,
                   "Colour of white in the halo: neutral, that of the photograph's sky, or any")
      ->type_name("sun|sky|R,G,B")
      ->check(CLI::Validator(validWhite, ""));
  command->add_option("--layers", options->layers, "Also write halo, mask, grid and linear sum into this folder")
      ->type_name("DIR");
  options->camera.addTo(*command);
  command->callback([options, &exit] { exit = runComposite(*options); });
}

}  // namespace parhelion::cli
