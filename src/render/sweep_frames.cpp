// SPDX-License-Identifier: Apache-2.0
#include "render/sweep_frames.h"

#include <stdexcept>

#include "picture/exr.h"
#include "picture/picture_text.h"
#include "render/mixed_sky.h"
#include "render/own_pictures.h"
#include "render/scene_attributes.h"

namespace parhelion {

namespace {

/// A file in the place of a frame or a preview that no render has written.
struct ForeignFile : std::runtime_error {
  using std::runtime_error::runtime_error;
};

[[noreturn]] void refuseFile(const std::string& why) {
  throw ForeignFile(why +
                    "; a sweep writes over nothing but pictures that parhelion has rendered; name other frames, or say "
                    "--overwrite");
}

/// The attributes of a file that render has written, whole or damaged. Throws if it is anything else.
ExrAttributes pictureAttributes(const std::filesystem::path& exr) {
  ExrAttributes attributes;
  try {
    attributes = readExrAttributes(exr);
  } catch (const std::runtime_error& error) {
    refuseFile(error.what());
  }
  if (!attributes.contains(kSceneKey)) refuseFile(exr.string() + ": holds no scene");
  if (attributes.contains(kTallyKey)) refuseFile(exr.string() + ": is a tally");
  if (attributes.contains(kStrengthKey)) refuseFile(exr.string() + ": is a photograph with a halo in it");
  return attributes;
}

/// Throws if something is in the place of a preview that is none, such as a user's own picture.
void requirePreview(const std::filesystem::path& png) {
  if (!std::filesystem::is_regular_file(png) || std::filesystem::file_size(png) == 0) return;
  std::map<std::string, std::string> text;
  try {
    text = readPictureText(png);
  } catch (const std::runtime_error& error) {
    refuseFile(error.what());
  }
  // Of our pictures only previews say at which exposure they were developed.
  if (!saysParhelion(text) || !text.contains("Exposure")) refuseFile(png.string() + ": is no preview of parhelion");
}

/// Why the file is not the picture of the scene with all its rays; empty if it is.
std::string lackOf(const std::filesystem::path& exr, const LoadedScene& loaded, Gamut gamut) {
  if (!std::filesystem::exists(exr)) return "not there yet";
  if (std::filesystem::is_regular_file(exr) && std::filesystem::file_size(exr) == 0) return "is empty";
  const ExrAttributes found = pictureAttributes(exr), wanted = sceneAttributes(loaded, raysOf(loaded.scene));
  Image image;
  try {
    image = readExr(exr).image;
  } catch (const std::runtime_error& error) {
    return std::string("is damaged: ") + error.what();
  }
  // A map holds the scene, too.
  if (!image.find("R") || !image.find("G") || !image.find("B")) refuseFile(exr.string() + ": is not in colours");
  for (const char* name : {"parhelion:version", "parhelion:seed", "parhelion:rays", kSceneKey}) {
    const auto attribute = found.find(name);
    if (attribute == found.end() || attribute->second != wanted.at(name)) return std::string("has another ") + name;
  }
  const auto errorIn = [](const ExrAttributes& attributes) {
    const auto error = attributes.find(kErrorKey);
    return error == attributes.end() ? std::string() : error->second;
  };
  if (errorIn(found) != errorIn(wanted)) return std::string("has another ") + kErrorKey;
  const auto written = found.find(kGamutKey);
  if ((written == found.end() ? nameOf(Gamut::exact) : written->second) != nameOf(gamut))
    return std::string("has another ") + kGamutKey;
  return {};
}

}  // namespace

std::string SweepFrame::valuesText() const {
  std::string text;
  for (const std::string& value : values) text += (text.empty() ? "" : ", ") + value;
  return text;
}

std::vector<SweepFrame> planFrames(std::span<const std::vector<std::string>> values, const FrameLoader& load,
                                   const FrameNames& names, std::size_t first, Gamut gamut, bool overwrite) {
  std::vector<SweepFrame> frames;
  for (const std::vector<std::string>& own : values)
    frames.push_back({own, load(own), names(first + frames.size()), gamut, {}});
  for (SweepFrame& frame : frames) {
    try {
      frame.lacks = lackOf(frame.exr, frame.loaded, gamut);
      requirePreview(frame.png());
    } catch (const ForeignFile&) {
      if (!overwrite) throw;
      frame.lacks = "is to be overwritten";
    }
  }
  return frames;
}

}  // namespace parhelion
