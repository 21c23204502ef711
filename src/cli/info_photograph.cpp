// SPDX-License-Identifier: Apache-2.0
#include "cli/info_photograph.h"

#include <cmath>
#include <stdexcept>
#include <variant>
#include <vector>

#include "cli/commands.h"
#include "cli/say.h"
#include "photo/lens_from_exif.h"
#include "picture/photograph.h"
#include "picture/picture_text.h"
#include "render/own_pictures.h"
#include "render/scene_attributes.h"
#include "scene/describe.h"
#include "scene/parse_scene.h"
#include "sky/camera.h"

namespace parhelion::cli {

namespace {

int bitsOf(const Samples& samples) { return std::holds_alternative<std::vector<std::uint8_t>>(samples) ? 8 : 16; }

/// Exif's "2024:01:31 12:00:00" as 2024-01-31 12:00:00; empty where it is unknown, which cameras write as blanks or
/// zeros.
std::string dateIn(std::string taken) {
  if (taken.find_first_of("123456789") == std::string::npos) return {};
  for (const std::size_t dash : {4, 7})
    if (taken.size() > dash && taken[dash] == ':') taken[dash] = '-';
  return taken;
}

/// Degrees along the sides, through the middle of the picture.
void printFieldOfView(const Photograph& photograph, double focalPixels) {
  const auto across = [&](int side) { return degrees(2.0 * std::atan(0.5 * side / focalPixels)); };
  answer("field of view: %.1f x %.1f degrees if rectilinear, as of %.3g mm on 35 mm film", across(photograph.width),
         across(photograph.height), equivalentOnFilm(focalPixels, photograph.width, photograph.height));
}

/// Of a picture of ours without Exif there is nothing to say: its camera is that of its scene.
void printLens(const Photograph& photograph, bool isOurs) {
  try {
    const auto lens = lensFromExif(photograph.exif, photograph.width, photograph.height);
    if (!lens && !isOurs)
      answer("lens: Exif does not tell; composite and view ask for --fov-horizontal or --focal-35mm");
    if (!lens) return;
    answer("lens: %s", lens->source.c_str());
    printFieldOfView(photograph, lens->focalPixels);
  } catch (const std::invalid_argument& error) {
    answer("lens: %s", error.what());
  }
}

}  // namespace

void printTexts(const std::map<std::string, std::string>& text, const std::string& path) {
  for (const auto& [key, value] : text)
    if (key != kSceneKey) answer("%s: %s", shortened(key).c_str(), shortened(value).c_str());
  const auto scene = text.find(kSceneKey);
  if (scene == text.end()) return;
  answer("made from the scene (print it with --scene):");
  answerLines(describeScene(parseScene(scene->second, path).scene));
}

int infoPhotograph(const std::string& path, const FileKind& kind) {
  const Photograph photograph = readPhotographHeader(path);
  const bool isJpeg = kind.family == FileKind::Family::jpeg;
  answer("%s: %s, %d x %d, %d bits%s", path.c_str(), isJpeg ? "JPEG" : "PNG", photograph.width, photograph.height,
         bitsOf(photograph.samples), photograph.channels == 4 ? ", with alpha" : "");
  const Exif& exif = photograph.exif;
  if (!exif.make.empty() || !exif.model.empty()) {
    const bool repeats = exif.model.starts_with(exif.make);
    answer("camera: %s", (repeats ? exif.model : exif.make + " " + exif.model).c_str());
  }
  if (const std::string date = dateIn(exif.taken); !date.empty()) answer("taken: %s", date.c_str());
  const std::map<std::string, std::string> text = isJpeg ? readPictureText(path) : photograph.text;
  printLens(photograph, saysParhelion(text));
  printTexts(text, path);
  return kDone;
}

}  // namespace parhelion::cli
