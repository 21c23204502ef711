// SPDX-License-Identifier: Apache-2.0
#include "cli/view_input.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "cli/commands.h"
#include "cli/file_words.h"
#include "cli/view_layers.h"
#include "photo/sky_mask.h"
#include "picture/auto_exposure.h"
#include "picture/exr.h"
#include "picture/picture_layers.h"
#include "recon/reconstruct.h"
#include "render/scene_attributes.h"
#include "render/sky_files.h"
#include "scene/parse_scene.h"
#include "scene/suggest.h"
#include "sky/radiance.h"
#include "sky/tally_exr.h"

namespace parhelion::cli {

namespace {

void requireColours(const std::string& path, const Image& image) {
  if (!image.find("R") || !image.find("G") || !image.find("B"))
    throw std::runtime_error(path + ": has no channels R, G, B");
}

/// The EXR with the name of a picture, whatever the case of its extension.
std::optional<std::filesystem::path> skyBeside(const std::filesystem::path& picture) {
  for (const char* extension : {".exr", ".EXR"}) {
    const std::filesystem::path exr = std::filesystem::path(picture).replace_extension(extension);
    if (std::filesystem::is_regular_file(exr) && isExr(exr)) return exr;
  }
  return std::nullopt;
}

void requireLayers(const std::string& path, const std::vector<std::string>& has,
                   const std::vector<std::string>& wanted) {
  if (has.empty()) throw Unfit("--layers: " + path + " has no layers; a scene asks for them by [[layer]]");
  const std::vector<std::string_view> accepted(has.begin(), has.end());
  for (const std::string& layer : wanted) {
    if (std::ranges::find(has, layer) != has.end()) continue;
    const std::string hint = didYouMean(layer, accepted);
    throw Unfit("--layers: " + path + " has no layer '" + layer + "'" + (hint.empty() ? "" : "; " + hint));
  }
}

/// Reads a picture of light.
void readLight(ViewInput& input, const PhotographRules& rules, const std::vector<std::string>& layers, bool withNames) {
  const auto scene = input.scene();
  const bool named = withNames && scene && !namedLayers(*scene, "the scene in " + input.path).empty();
  const bool whole = named || !layers.empty();
  Image image = readExr(input.path, exrColours(rules), {!whole, rules.bytesForUse, rules.editedPictures()}).image;
  requireColours(input.path, image);
  if (!layers.empty()) requireLayers(input.path, layersOf(image), layers);
  if (whole) {
    Image apart = takeLayers(image);
    if (!layers.empty()) image = sumOfLayers(apart, layers);
    if (named) input.layers = std::move(apart);
  }
  input.light = std::move(image);
}

}  // namespace

bool ViewInput::isPhotograph() const { return !scene() || photograph.text.contains(kStrengthKey); }

std::optional<std::string> ViewInput::scene() const {
  const auto found = photograph.text.find(kSceneKey);
  return found == photograph.text.end() ? std::nullopt : std::optional(found->second);
}

ViewInput readViewInput(const std::string& path, const PhotographRules& rules, const std::vector<std::string>& layers,
                        bool withNames) {
  ViewInput input;
  requireFit(path, Wanted::view);
  input.path = input.sceneFile = path;
  if (!isExr(path)) {
    input.photograph = readPhotograph(path, rules);
    if (!layers.empty()) throw Unfit("--layers: " + path + " is a photograph, and has no layers of light");
    return input;
  }
  ExrFrame frame = readExrFrame(path);
  input.photograph.width = frame.width;
  input.photograph.height = frame.height;
  input.photograph.text = std::move(frame.attributes);
  if (input.photograph.text.contains(kTallyKey)) {
    const SkyTally sky = readSkyTallyExr(path);
    input.tally = sky.flattened();
    input.hasRings = std::ranges::count(sky.symmetries(), TallySymmetry::radial) > 0;
    if (!layers.empty()) {
      requireLayers(path, sky.layers(), layers);
      LayerGains gains;
      for (const std::string& layer : sky.layers()) gains[layer] = 0.0;
      for (const std::string& layer : layers) gains[layer] = 1.0;
      input.light = reconstruct(sky, NoSettings{}, gains).image;
    } else {
      input.light = plainRadiance(*input.tally);
    }
  } else {
    readLight(input, rules, layers, withNames);
  }
  return input;
}

void takeSceneBeside(ViewInput& input) {
  if (input.scene() || input.light) return;
  const std::optional<std::filesystem::path> exr = skyBeside(input.path);
  if (!exr) return;
  const ExrAttributes attributes = readExrAttributes(*exr);
  const auto scene = attributes.find(kSceneKey);
  if (scene == attributes.end() || attributes.contains(kStrengthKey)) return;
  const CameraSettings camera = parseScene(scene->second, exr->string()).scene.camera;
  if (!hasShapeOf(input.photograph, camera)) return;
  input.photograph.text[kSceneKey] = scene->second;
  input.sceneFile = exr->string();
}

Shown show(const ViewInput& input, const LightDisplay& how) {
  if (!input.light) return {shown(input.photograph), std::nullopt};
  const std::optional<double> white = whiteLuminanceOf(input.photograph.text);
  if (how.exposureValue && !white)
    throw CLI::ValidationError(
        "--ev",
        input.path + " is in no absolute unit: it has no whiteLuminance, the cd/m2 of its white; give --exposure");
  LightDisplay chosen = how;
  const auto scene = input.scene();
  if (white && scene && !how.exposure && !how.exposureValue)
    chosen.exposure = ownExposure(*input.light, parseScene(*scene, input.sceneFile).scene);
  const ToneSettings tone = toneFor(chosen, *input.light, white);
  return {developed(*input.light, tone), tone.exposureStops};
}

Image lightOf(ViewInput input) { return input.light ? std::move(*input.light) : linearImage(input.photograph); }

std::vector<std::uint8_t> readMaskFor(const std::string& path, int width, int height) {
  requireFit(path, Wanted::photograph);
  SkyMask mask = readSkyMask(path);
  if (mask.width != width || mask.height != height)
    throw std::runtime_error(path + ": the mask is " + sizeText(mask.width, mask.height) + ", the picture " +
                             sizeText(width, height));
  return std::move(mask.sky);
}

}  // namespace parhelion::cli
