// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <utility>

#include "cli/commands.h"
#include "cli/outputs.h"
#include "cli/say.h"
#include "cli/view_input.h"
#include "cli/view_layers.h"
#include "cli/view_options.h"
#include "cli/view_profile.h"
#include "optics/ice.h"
#include "picture/transfer.h"
#include "render/crystal_sides.h"
#include "render/scene_attributes.h"
#include "render/sky_files.h"
#include "scene/parse_scene.h"
#include "scene/scene_halos.h"
#include "scene/view_difference.h"
#include "sky/camera.h"
#include "view/beside.h"
#include "view/colour_difference.h"
#include "view/dots.h"
#include "view/glare.h"
#include "view/lens_star.h"
#include "view/line_art.h"

namespace parhelion::cli {

namespace {

constexpr double kEyesWavelength = 550.0;      // nm, for which halos are placed
constexpr std::uint8_t kDotsUnderLines = 153;  // sRGB grey of 60 %, on which lines and letters can be read

/// A view in the making, and what there is to say of it.
struct View {
  Preview picture;
  std::optional<Display> deep = std::nullopt;  // in its place, where more than 8 bits are asked for
  std::vector<std::string> remarks;
};

std::string text(const char* format, double a, double b = 0.0) {
  char line[100];
  std::snprintf(line, sizeof line, format, a, b);
  return line;
}

/// The camera of a picture: as the options say, by the scene in it, or, of a second picture that has none, the first's.
PhotoCamera cameraOf(const ViewInput& input, const ViewOptions& view, const PhotoCamera* first = nullptr) {
  const PhotoOptions& options = view.photo;
  const std::optional<std::string> scene = input.scene();
  if (first && !scene) {
    const CameraSettings& camera = first->camera;
    if (input.photograph.width != camera.width || input.photograph.height != camera.height)
      throw CLI::ValidationError(
          "--beside", input.path + " has no scene in it and is " +
                          sizeText(input.photograph.width, input.photograph.height) + ", the first picture " +
                          sizeText(camera.width, camera.height) +
                          ": the one camera cannot be that of both; give a picture of that size, or view each alone");
    return *first;
  }
  std::optional<double> sunElevation;
  if (scene && !first) sunElevation = parseScene(*scene, "the scene in " + input.sceneFile).scene.sun.elevation;
  if (!scene && !view.scene.empty()) sunElevation = loadScene(view.scene).scene.sun.elevation;
  try {
    return (first ? PhotoOptions{} : options).camera(input.photograph, input.path, sunElevation);
  } catch (const CLI::ValidationError& error) {
    if (first || !scene || !options.given()) throw;
    throw CLI::ValidationError(std::string(error.what()) +
                               "; the scene in the picture has its camera, which goes without camera options");
  }
}

/// Whose halos are drawn over a picture.
struct Crystals {
  std::vector<HaloMaker> makers;
  IceSettings ice;
  std::string remark;
};

/// Those of all makers that make halos of these families.
std::vector<HaloMaker> makersOf(const std::vector<HaloFamily>& families) {
  std::vector<HaloMaker> makers;
  for (HaloMaker& maker : allHaloMakers()) {
    if (maker.family == HaloFamily::random) maker.faces = prismFaces();
    if (std::find(families.begin(), families.end(), maker.family) != families.end()) makers.push_back(maker);
  }
  if (std::find(families.begin(), families.end(), HaloFamily::pyramids) != families.end())
    makers.push_back({HaloFamily::pyramids, pyramidFaces()});
  return makers;
}

Crystals crystalsOf(const Scene& scene, const std::string& file) {
  SceneHalos halos = halosOf(scene.populations);
  std::string remark = "halos of the crystals in " + file;
  for (const std::string& name : halos.nameless) remark += "; none has a name of those of \"" + name + '"';
  return {std::move(halos.makers), scene.ice, std::move(remark)};
}

Crystals crystalsOf(const ViewInput& input, const ViewOptions& options) {
  std::optional<Scene> own;
  if (const auto scene = input.scene()) own = parseScene(*scene, "the scene in " + input.sceneFile).scene;
  const IceSettings ice = own ? own->ice : IceSettings{};
  if (!options.crystals.empty()) return {makersOf(options.families()), ice, ""};
  if (!options.scene.empty()) return crystalsOf(loadScene(options.scene).scene, options.scene);
  if (own) return crystalsOf(*own, input.sceneFile);
  return {allHaloMakers(), ice,
          "halos of all crystals: " + input.path + " has no scene; --scene or --crystals says less"};
}

/// Whether a picture shows ground, or nothing, below the horizon, and no halos.
bool endsAtHorizon(const Scene& scene) { return scene.camera.horizon == Horizon::cut || !crystalSides(scene).below; }

/// Lines and letters for what a picture shows.
LineArt linesOver(const ViewInput& input, const PhotoCamera& camera, const ViewOptions& options) {
  OverlaySettings settings = options.overlaySettings();
  std::optional<Scene> own;
  if (const auto scene = input.scene()) own = parseScene(*scene, "the scene in " + input.sceneFile).scene;
  settings.belowHorizon = options.belowHorizon.value_or(!input.isPhotograph() && !(own && endsAtHorizon(*own)));
  if (const std::string unlit = own ? whyUnlit(*own) : ""; !unlit.empty() && settings.halos) {
    settings.halos = false;
    if (!options.quiet) say("no halos: %s", unlit.c_str());
  }
  Crystals crystals = settings.halos ? crystalsOf(input, options) : Crystals{};
  settings.makers = std::move(crystals.makers);
  settings.names = layerNames(input, camera.camera, options.layers, settings);
  if (!options.quiet && !crystals.remark.empty()) say("%s", crystals.remark.c_str());
  return drawOverlay(camera.camera, camera.sunElevation, refractiveIndex(crystals.ice, kEyesWavelength), settings);
}

ColourDifference maskedRedMinusBlue(Display picture, const ViewOptions& options) {
  if (options.mask.empty()) return redMinusBlue(std::move(picture), options.gain);
  const std::vector<std::uint8_t> sky = readMaskFor(options.mask, picture.width, picture.height);
  try {
    return redMinusBlue(std::move(picture), options.gain, sky);
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(options.mask + ": " + error.what());
  }
}

View filtered(const ViewInput& input, const ViewOptions& options) {
  View view;
  if (options.dots) {
    if (!input.tally)
      throw CLI::ValidationError("--dots",
                                 input.path + " holds no hits; parhelion trace SCENE -o hits.exr makes such a file");
    view.picture = dots(*input.tally, options.dotSize.value_or(usualDotSize(*input.tally)),
                        options.drawsLines() ? kDotsUnderLines : 0);
    if (input.hasRings)
      view.remarks.push_back(
          "random crystals are counted in rings here, which light every pixel of them: trace with "
          "--symmetry mirror for dots");
    return view;
  }
  Shown shown = show(input, options.display.settings());
  if (shown.exposure) view.remarks.push_back(text("exposure %+.2f stops", *shown.exposure));
  if (!options.unsharp.empty()) unsharp(shown.display, options.unsharpSettings());
  if (options.redMinusBlue) {
    ColourDifference difference = maskedRedMinusBlue(std::move(shown.display), options);
    view.remarks.push_back(text("gain %.4g about %.4g", difference.gain, difference.centre));
    shown.display = std::move(difference.picture);
  }
  if (options.bits > 8)
    view.deep = std::move(shown.display);
  else
    view.picture = quantised(shown.display);
  return view;
}

/// Light is taken off pixel by pixel: throws if the pictures say that their pixels show different parts of the sky.
void requireOneSky(const ViewInput& one, const ViewInput& other) {
  if (!one.scene() || !other.scene()) return;
  const std::vector<std::string> differ =
      differencesOfView(parseScene(*one.scene(), "the scene in " + one.path).scene,
                        parseScene(*other.scene(), "the scene in " + other.path).scene);
  if (differ.empty()) return;
  std::string all;
  for (const std::string& difference : differ) all += (all.empty() ? "" : ", ") + difference;
  throw CLI::ValidationError("--minus", one.path + " and " + other.path + " differ in " + all +
                                            ": their pixels show different parts of the sky");
}

/// One of the two kinds of light has a unit, the other has white: only the user knows how they compare.
View difference(const ViewInput& one, const ViewInput& other, const ViewOptions& options) {
  requireOneSky(one, other);
  if (one.light.has_value() != other.light.has_value() && !options.display.exposure)
    throw CLI::ValidationError("--minus", "between a photograph and linear light give --exposure for the latter");
  const auto light = [&](const ViewInput& input) {
    Image image = lightOf(input);
    if (input.light && options.display.exposure)
      for (Channel& channel : image.channels)
        for (float& sample : channel.samples) sample *= static_cast<float>(std::exp2(*options.display.exposure));
    return image;
  };
  try {
    const LightDifference difference = minus(light(one), light(other), options.gain);
    return {quantised(difference.picture), std::nullopt, {text("gain %.4g", difference.gain)}};
  } catch (const std::invalid_argument& error) {
    throw CLI::ValidationError("--minus", one.path + " and " + other.path + ": " + error.what());
  }
}

template <class Sample>
std::vector<Sample> encoded(const Image& light) {
  std::vector<Sample> samples(3 * light.pixels());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const float linear = (*light.rgb()[i % 3])[i / 3];
    if constexpr (sizeof(Sample) == 1)
      samples[i] = toSrgb8(linear);
    else
      samples[i] = toSrgb16(linear);
  }
  return samples;
}

/// Averages over squares of pixels, in linear light.
Photograph reduced(const Photograph& photograph, int reduction) {
  const Image light = linearImage(photograph, reduction);
  Photograph smaller;
  smaller.width = light.width;
  smaller.height = light.height;
  if (std::holds_alternative<std::vector<std::uint8_t>>(photograph.samples))
    smaller.samples = encoded<std::uint8_t>(light);
  else
    smaller.samples = encoded<std::uint16_t>(light);
  return smaller;
}

void writeView(View view, const ViewInput& input, const ViewOptions& options, Transaction& outputs) {
  std::map<std::string, std::string> said{{"Software", kSoftware}};
  // Of two pictures neither's scene holds for the whole.
  if (const auto scene = input.scene(); scene && options.beside.empty()) said[kSceneKey] = *scene;
  Photograph photograph;
  photograph.width = view.deep ? view.deep->width : view.picture.width;
  photograph.height = view.deep ? view.deep->height : view.picture.height;
  if (view.deep)
    photograph.samples = quantised16(*view.deep);
  else
    photograph.samples = std::move(view.picture.rgb);
  if (options.reduction > 1) photograph = reduced(photograph, options.reduction);
  writePhotograph(outputs.at(options.output), photograph, said);
  if (options.quiet) return;
  for (const std::string& remark : view.remarks) say("%s", remark.c_str());
}

/// Whether a lens shows nothing in a pixel's middle, as around the disc of a fisheye.
bool isOutsideSky(const Camera& camera, std::size_t pixel) {
  const auto width = static_cast<std::size_t>(camera.width());
  return !camera.toSky({static_cast<double>(pixel % width) + 0.5, static_cast<double>(pixel / width) + 0.5});
}

/// Adds the glare of an eye or a lens to a picture of linear light.
void dazzle(ViewInput& input, const ViewOptions& options) {
  if (!input.light)
    throw CLI::ValidationError("--glare", "is for linear light; " + input.path + " has been developed already");
  const std::optional<std::string> scene = input.scene();
  if (!scene)
    throw CLI::ValidationError(
        "--glare", input.path + " has no scene that tells its camera, so how far apart its pixels are is not known");
  const Camera camera(parseScene(*scene, "the scene in " + input.sceneFile).scene.camera);
  Image& light = *input.light;
  const bool isWhole = light.width == camera.width() && light.height == camera.height();
  std::vector<std::size_t> outside;  // glare is not seen there, either
  for (std::size_t i = 0; i < light.pixels() && isWhole; ++i)
    if (std::ranges::all_of(light.rgb(), [i](const auto* plane) { return (*plane)[i] == 0.0F; }) &&
        isOutsideSky(camera, i))
      outside.push_back(i);
  const double pixel = 1.0 / camera.focalLength();
  if (options.glare == "lens") {
    const LensAperture usual;
    if (addLensStar(light, pixel, {options.blades.value_or(usual.blades), options.aperture.value_or(usual.diameter)}) ==
            0 &&
        !options.quiet)
      say("nothing in %s is bright enough for a star", input.path.c_str());
  } else {
    addGlare(light, pixel);
  }
  for (const std::size_t i : outside)
    for (Channel& channel : light.channels) channel.samples[i] = 0.0F;
}

/// Reads the second picture, if there is one. Throws for options that have no meaning for what is in the files.
std::vector<ViewInput> readPictures(const ViewOptions& options) {
  constexpr int kBytesForUse = 16;  // a pixel: three floats, and the view of 8 bits
  const PhotographRules rules = options.photo.rules(kBytesForUse);
  const OverlaySettings overlay = options.overlaySettings();
  const bool withNames = options.drawsLines() && overlay.halos && overlay.labels;
  std::vector<ViewInput> pictures{readViewInput(options.input, rules, options.layers, withNames)};
  for (const std::string& other : options.beside)
    pictures.push_back(readViewInput(other, rules, options.layers, withNames));
  if (!options.minus.empty()) pictures.push_back(readViewInput(options.minus, rules, options.layers));
  if (options.needsCamera() && !options.photo.given())
    for (ViewInput& picture : pictures) takeSceneBeside(picture);
  if (options.addsGlare())
    for (ViewInput& picture : pictures) dazzle(picture, options);
  const char* ofLight = options.display.exposure ? "--exposure" : options.display.exposureValue ? "--ev" : "--tone";
  if ((options.display.exposure || options.display.exposureValue || !options.display.tone.empty()) &&
      std::none_of(pictures.begin(), pictures.end(), [](const auto& p) { return p.light; }))
    throw CLI::ValidationError(ofLight, "is for linear light; " + options.input + " has been developed already");
  return pictures;
}

std::vector<PhotoCamera> camerasOf(const std::vector<ViewInput>& pictures, const ViewOptions& options) {
  std::vector<PhotoCamera> cameras{cameraOf(pictures[0], options)};
  for (std::size_t i = 1; i < pictures.size() && options.minus.empty(); ++i)
    cameras.push_back(cameraOf(pictures[i], options, &cameras[0]));
  if (options.quiet) return cameras;
  for (const std::string& remark : cameras[0].remarks) say("%s", remark.c_str());
  if (pictures[0].scene() && !options.photo.given())
    say("camera and sun of the scene in %s", pictures[0].sceneFile.c_str());
  return cameras;
}

void profileView(std::vector<ViewInput> pictures, const ViewOptions& options, Transaction& outputs) {
  const std::vector<PhotoCamera> cameras = camerasOf(pictures, options);
  std::vector<std::uint8_t> mask;
  if (!options.mask.empty()) mask = readMaskFor(options.mask, cameras[0].camera.width, cameras[0].camera.height);
  std::vector<Observed> observed;
  for (std::size_t i = 0; i < pictures.size(); ++i) observed.push_back({std::move(pictures[i]), cameras[i]});
  writeProfile(options, std::move(observed), mask, outputs);
}

/// The views of the pictures with their lines; writes the lines' layer where that is asked for.
std::vector<View> pictureViews(const std::vector<ViewInput>& pictures, const ViewOptions& options,
                               Transaction& outputs) {
  // First what may be missing of the cameras, then the work.
  std::vector<PhotoCamera> cameras;
  if (options.drawsLines()) cameras = camerasOf(pictures, options);
  std::vector<View> views;
  if (options.minus.empty())
    for (const ViewInput& picture : pictures) views.push_back(filtered(picture, options));
  else
    views.push_back(difference(pictures[0], pictures[1], options));
  for (std::size_t i = 0; i < views.size() && options.drawsLines(); ++i) {
    const LineArt lines = linesOver(pictures[i], cameras[i], options);
    if (!options.layer.empty()) writeLineArt(outputs.at(options.layer), lines, {{"Software", kSoftware}});
    if (views[i].deep)
      layOver(*views[i].deep, lines);
    else
      layOver(views[i].picture, lines);
  }
  return views;
}

void pictureView(const std::vector<ViewInput>& pictures, const ViewOptions& options, Transaction& outputs) {
  std::vector<View> views = pictureViews(pictures, options, outputs);
  if (options.output.empty()) return;
  for (std::size_t i = 1; i < views.size(); ++i) {
    views[0].picture = beside(views[0].picture, views[i].picture);
    views[0].remarks.insert(views[0].remarks.end(), views[i].remarks.begin(), views[i].remarks.end());
  }
  writeView(std::move(views[0]), pictures[0], options, outputs);
}

int runView(const ViewOptions& options) {
  options.requireSense();
  const auto names = {options.output, options.layer, options.profile, options.chart};
  Files files{{options.input, options.minus, options.mask}, names};
  files.inputs.insert(files.inputs.end(), options.beside.begin(), options.beside.end());
  Transaction outputs = claimOutputs(files, options.overwrite);
  std::vector<ViewInput> pictures = readPictures(options);
  if (options.profile.empty())
    pictureView(pictures, options, outputs);
  else
    profileView(std::move(pictures), options, outputs);
  outputs.commit();
  for (const std::string& name : names)
    if (!name.empty() && name != "-" && !options.quiet) say("wrote %s", name.c_str());
  return kDone;
}

}  // namespace

void addView(CLI::App& app, int& exit) {
  auto options = std::make_shared<ViewOptions>();
  CLI::App* command = app.add_subcommand("view", "A photograph, sky or tally as halo observers look at it");
  options->addTo(*command);
  command->callback([options, &exit] { exit = runView(*options); });
}

}  // namespace parhelion::cli
