// SPDX-License-Identifier: Apache-2.0
#include "render/composite.h"

#include <cstdio>
#include <map>
#include <stdexcept>
#include <string>

#include "optics/ice.h"
#include "parallel/threads.h"
#include "photo/editing_pictures.h"
#include "photo/find_sky.h"
#include "photo/found_mask.h"
#include "picture/jpeg_patch.h"
#include "render/scene_attributes.h"
#include "scene/parse_scene.h"
#include "scene/scene_halos.h"
#include "sky/envmap.h"
#include "view/overlay.h"

namespace parhelion {

namespace {

using Text = std::map<std::string, std::string>;

/// What the pictures say of themselves.
Text textOf(const ExrAttributes& attributes, const Vec3& perRadiance) {
  Text text = attributes;
  char strength[100];
  std::snprintf(strength, sizeof strength, "%.9g %.9g %.9g", perRadiance.x, perRadiance.y, perRadiance.z);
  text[kStrengthKey] = strength;
  text["Software"] = text["software"] = kSoftware;  // also where another version has made the halo
  return text;
}

void writeEditingPictures(const CompositeFiles& files, const Photograph& photograph, const AddedHalo& added,
                          const PhotoCamera& camera, const Text& text) {
  const std::vector<std::filesystem::path> pictures = editingFiles(files.editingFolder);
  const auto at = [&](std::size_t i) { return Output(pictures[i], files.run); };
  writePhotograph(at(0), lightForEditing(added), text);
  writePhotograph(at(1), sumForEditing(photograph, added), text);
  writePhotograph(at(2), dodgeForEditing(photograph, added), text);
  writeSkyMask(at(3), added.mask, text);
  const Scene scene = parseScene(text.at(kSceneKey), "the halo's scene").scene;
  OverlaySettings grid;
  grid.halos = true;
  grid.makers = halosOf(scene.populations).makers;
  grid.belowHorizon = false;
  constexpr double kGreen = 550.0;  // nm
  const double index = refractiveIndex(scene.ice, kGreen);
  writeLineArt(at(4), drawOverlay(camera.camera, camera.sunElevation, index, grid), text);
}

AddedHaloReport writePicture(const CompositeFiles& files, Photograph& photograph, const AddedHalo& added,
                             const PhotoCamera& camera, const Text& text) {
  const std::string kind = extensionOf(files.output);
  const bool codes = !std::holds_alternative<std::vector<float>>(photograph.samples);
  const Envmap envmap = envmapOf(Camera(camera.camera));
  const Output output(files.output, files.run);
  if (kind == ".exr" && codes) writePhotograph(output, sumForEditing(photograph, added), text, envmap);
  const AddedHaloReport done = addHalo(photograph, added);
  if (kind == ".exr" && codes) return done;
  if (kind != ".jpg" && kind != ".jpeg") {
    writePhotograph(output, photograph, text, envmap);
  } else if (!writePatchedJpeg(output, files.photo, photograph, text.at("Software"))) {
    writePhotograph(output, photograph, text);
  }
  return done;
}

}  // namespace

SkyMask allSky(const Photograph& photograph) {
  return {photograph.width, photograph.height, std::vector<std::uint8_t>(photograph.pixels(), 255)};
}

SkyMask findSkyAbove(const Photograph& photograph, const CameraSettings& camera, int threads) {
  SkyMask found = withThreads(threads, [&] { return findSky(photograph); });
  cutBelowHorizon(found, camera);
  return found;
}

SkyMask readSkyMaskOf(const Photograph& photograph, const std::filesystem::path& path) {
  SkyMask mask = readSkyMask(path);
  if (mask.width != photograph.width || mask.height != photograph.height)
    throw std::runtime_error(path.string() + ": the mask has " + std::to_string(mask.width) + " x " +
                             std::to_string(mask.height) + " pixels, the photograph, turned upright, " +
                             std::to_string(photograph.width) + " x " + std::to_string(photograph.height));
  return mask;
}

std::vector<std::filesystem::path> editingFiles(const std::filesystem::path& editingFolder) {
  std::vector<std::filesystem::path> files;
  if (editingFolder.empty()) return files;
  for (const char* name : {"halo.exr", "sum.exr", "halo-dodge.png", "mask.png", "grid.png"})
    files.push_back(editingFolder / name);
  return files;
}

AddedHaloReport writeComposite(const CompositeFiles& files, Photograph photograph, const AddedHalo& added,
                               const PhotoCamera& camera, const ExrAttributes& attributes, int threads) {
  const Text text = textOf(attributes, added.perRadiance);
  return withThreads(threads, [&] {
    if (!files.editingFolder.empty()) writeEditingPictures(files, photograph, added, camera, text);
    const AddedHaloReport done = writePicture(files, photograph, added, camera, text);
    if (!files.foundMask.empty()) writeFoundMask({files.foundMask, files.run}, added.mask, text.at("software"));
    return done;
  });
}

}  // namespace parhelion
