// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "cli/commands.h"
#include "cli/halo_source.h"
#include "cli/photo_options.h"
#include "cli/tally_run.h"
#include "cli/text_output.h"
#include "optics/ice.h"
#include "parallel/threads.h"
#include "photo/added_halo.h"
#include "photo/editing_pictures.h"
#include "photo/find_sky.h"
#include "photo/found_mask.h"
#include "photo/sky_match.h"
#include "picture/colour_space.h"
#include "picture/jpeg_patch.h"
#include "sky/envmap.h"
#include "view/overlay.h"

namespace parhelion::cli {

namespace {

/// The 99th percentile of the halo adds this share of the sky's luminance when nothing else is said: a display that
/// nobody overlooks.
constexpr double kUsualContrast = 0.5;

constexpr const char* kLayerFiles[] = {"halo.exr", "sum.exr", "halo-dodge.png", "mask.png", "grid.png"};

struct CompositeOptions {
  std::string photo, output, mask, maskOutput, layers, white = "sun";
  HaloSource halo;
  PhotoOptions camera;
  std::optional<double> strength, contrast;
  bool allSky = false;

  bool findsSky() const { return mask.empty() && !allSky; }
  std::filesystem::path foundMask() const {
    if (!maskOutput.empty()) return maskOutput;
    const std::filesystem::path out = output;
    return out.parent_path() / (out.stem().string() + "-mask.png");
  }
  std::filesystem::path layer(const char* name) const { return std::filesystem::path(layers) / name; }
};

/// "1,0.9,0.8", positive; none where it is anything else.
std::optional<Vec3> colour(const std::string& text) {
  Vec3 rgb;
  int length = 0;
  if (std::sscanf(text.c_str(), "%lf,%lf,%lf%n", &rgb.x, &rgb.y, &rgb.z, &length) != 3) return std::nullopt;
  const bool whole = length == static_cast<int>(text.size());
  return whole && rgb.x > 0.0 && rgb.y > 0.0 && rgb.z > 0.0 && std::isfinite(rgb.x + rgb.y + rgb.z) ? std::optional(rgb)
                                                                                                    : std::nullopt;
}

std::string validWhite(const std::string& text) {
  if (text == "sun" || text == "sky" || colour(text)) return {};
  return "expected sun, sky or R,G,B (positive numbers), not '" + text + "'";
}

void requireSense(const CompositeOptions& options) {
  options.halo.requireOne();
  if (options.strength && options.contrast) throw CLI::ValidationError("--strength and --contrast exclude each other");
  if (options.allSky && !options.mask.empty()) throw CLI::ValidationError("--mask and --all-sky exclude each other");
  if (!options.maskOutput.empty() && !options.findsSky())
    throw CLI::ValidationError("--mask-out is for a mask that is found; --mask or --all-sky say it already");
}

/// All that will be written can be, and nothing is written over an input or another output.
void requireAll(const CompositeOptions& options) {
  std::vector<std::string> outputs{options.output, options.findsSky() ? options.foundMask().string() : "",
                                   options.halo.run.stats};
  const auto check = [&] {
    for (const std::string& input : {options.photo, options.mask, options.halo.file()}) {
      if (!input.empty()) requireOutputs(input, outputs);
    }
  };
  check();
  if (options.layers.empty()) return;
  std::filesystem::create_directory(options.layers);
  for (const char* name : kLayerFiles) outputs.push_back(options.layer(name).string());
  check();
}

SkyMask maskOf(const CompositeOptions& options, const Photograph& photograph, const PhotoCamera& camera) {
  if (options.allSky) return {photograph.width, photograph.height, std::vector<std::uint8_t>(photograph.pixels(), 255)};
  if (options.mask.empty()) {
    SkyMask found = findSky(photograph);
    cutBelowHorizon(found, camera.camera);
    return found;
  }
  SkyMask mask = readSkyMask(options.mask);
  if (mask.width != photograph.width || mask.height != photograph.height)
    throw std::runtime_error(options.mask + ": the mask has " + std::to_string(mask.width) + " x " +
                             std::to_string(mask.height) + " pixels, the photograph, turned upright, " +
                             std::to_string(photograph.width) + " x " + std::to_string(photograph.height));
  return mask;
}

/// What the halo's radiance is multiplied by, in words on stderr too.
Vec3 perRadiance(const CompositeOptions& options, const Photograph& photograph, const SkyMask& mask,
                 const PhotoCamera& camera, const HaloLookup& halo) {
  const bool quiet = options.halo.run.quiet;
  std::optional<SkyTone> sky;
  if (!options.strength || options.white == "sky") sky = skyTone(photograph, mask, camera.camera, camera.sunElevation);
  Vec3 white = options.white == "sun" ? Vec3(1.0) : options.white == "sky" ? sky->colour : *colour(options.white);
  white /= glm::dot(white, kRec709Luminance);
  double strength = options.strength.value_or(0.0);
  if (!options.strength) {
    const double bright = brightHalo(halo, mask), contrast = options.contrast.value_or(kUsualContrast);
    if (bright == 0.0 && !quiet) std::fprintf(stderr, "there is no halo in the photograph's sky\n");
    if (bright > 0.0) strength = contrast * sky->luminance / bright;
    if (!quiet)
      std::fprintf(stderr, "strength: %g, by which the halo's bright parts have %g of the luminance of the sky%s\n",
                   strength, contrast, sky->aroundSun ? " around the sun" : "");
  }
  return strength * white;
}

void writeLayers(const CompositeOptions& options, const Photograph& photograph, const AddedHalo& added,
                 const PhotoCamera& camera, const std::map<std::string, std::string>& text) {
  writePhotograph(options.layer(kLayerFiles[0]), lightForEditing(added), text);
  writePhotograph(options.layer(kLayerFiles[1]), sumForEditing(photograph, added), text);
  writePhotograph(options.layer(kLayerFiles[2]), dodgeForEditing(photograph, added), text);
  writeSkyMask(options.layer(kLayerFiles[3]), added.mask, text);
  OverlaySettings grid;
  grid.halos = true;
  constexpr double kGreen = 550.0;  // nm
  writeLineArt(options.layer(kLayerFiles[4]), drawOverlay(camera.camera, camera.sunElevation, iceIndex(kGreen), grid),
               text);
}

/// A JPEG out of a JPEG keeps what the halo does not touch, an EXR holds light beyond white.
AddedHaloReport writeComposite(const CompositeOptions& options, Photograph& photograph, const AddedHalo& added,
                               const PhotoCamera& camera, const std::map<std::string, std::string>& text) {
  const std::filesystem::path out = options.output;
  const std::string kind = extensionOf(out);
  const bool codes = !std::holds_alternative<std::vector<float>>(photograph.samples);
  const Envmap envmap = envmapOf(Camera(camera.camera));
  if (kind == ".exr" && codes) writePhotograph(out, sumForEditing(photograph, added), text, envmap);
  const AddedHaloReport done = addHalo(photograph, added);
  if (kind == ".exr" && codes) return done;
  if (kind != ".jpg" && kind != ".jpeg") {
    writePhotograph(out, photograph, text, envmap);
  } else if (!writePatchedJpeg(out, options.photo, photograph)) {
    writePhotograph(out, photograph, text);
  }
  return done;
}

void report(const CompositeOptions& options, const Photograph& photograph, const AddedHaloReport& done) {
  const double pixels = static_cast<double>(photograph.pixels());
  std::fprintf(stderr, "the halo touches %.1f %% of the picture", 100.0 * static_cast<double>(done.touched) / pixels);
  if (done.clipped > 0)
    std::fprintf(stderr, ", %.2f %% becomes whiter than white and is clipped",
                 100.0 * static_cast<double>(done.clipped) / pixels);
  if (done.uncovered > 0)
    std::fprintf(stderr, "; %.1f %% is sky that the halo's picture does not reach",
                 100.0 * static_cast<double>(done.uncovered) / pixels);
  std::fprintf(stderr, "\nwrote %s", options.output.c_str());
  if (options.findsSky())
    std::fprintf(stderr, " and the sky found in it, %s (correct it and give it back with --mask)",
                 options.foundMask().c_str());
  std::fprintf(stderr, "\n");
}

int runComposite(const CompositeOptions& options) {
  requireSense(options);
  requireAll(options);
  const StopSignal stop;
  Photograph photograph = readPhotograph(options.photo, options.camera.rules());
  const PhotoCamera camera = options.camera.camera(photograph, options.photo, options.halo.sunElevation());
  if (!options.halo.run.quiet)
    for (const std::string& remark : camera.remarks) std::fprintf(stderr, "%s\n", remark.c_str());

  const int threads = options.halo.run.threads;
  const SkyMask mask = withThreads(threads, [&] { return maskOf(options, photograph, camera); });
  if (options.findsSky()) requireUnchangedMask(options.foundMask());
  const HaloSource::Result halo = options.halo.make(camera, stop);
  const AddedHalo added{halo.lookup, mask, perRadiance(options, photograph, mask, camera, halo.lookup)};

  std::map<std::string, std::string> text = halo.attributes;
  char strength[100];
  std::snprintf(strength, sizeof strength, "%.9g %.9g %.9g", added.perRadiance.x, added.perRadiance.y,
                added.perRadiance.z);
  text[kStrengthKey] = strength;
  text["Software"] = text["software"];
  return withThreads(threads, [&] {
    if (!options.layers.empty()) writeLayers(options, photograph, added, camera, text);
    const AddedHaloReport done = writeComposite(options, photograph, added, camera, text);
    if (options.findsSky()) writeFoundMask(options.foundMask(), mask, text["software"]);
    if (!options.halo.run.quiet) report(options, photograph, done);
    return halo.exitCode;
  });
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
      ->type_name("FILE");
  command->add_flag("--all-sky", options->allSky, "Take all of the picture for sky");
  command->add_option("--strength", options->strength, "Linear samples per radiance (1/sr) of the halo")
      ->type_name("FACTOR")
      ->check(number(0.0, 1e12));
  command
      ->add_option("--contrast", options->contrast,
                   "Instead: luminance of the halo's bright parts over that of the sky around the sun; 0.5")
      ->type_name("SHARE")
      ->check(number(0.0, 1e6));
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
