// SPDX-License-Identifier: Apache-2.0
#include "cli/sweep_frames.h"

#include <stdexcept>

#include "cli/tally_run.h"
#include "picture/exr.h"
#include "picture/photograph.h"

namespace parhelion::cli {

namespace {

[[noreturn]] void refusePattern(const std::string& pattern, const std::string& reason) {
  throw CLI::ValidationError("-o", "'" + pattern + "': " + reason);
}

[[noreturn]] void refuseFile(const std::string& why) {
  throw std::runtime_error(why + "; a sweep writes over nothing but pictures that parhelion has rendered");
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
  if (attributes.contains("parhelion:tally")) refuseFile(exr.string() + ": is a tally");
  if (attributes.contains(kStrengthKey)) refuseFile(exr.string() + ": is a photograph with a halo in it");
  return attributes;
}

/// Throws if something is in the place of a preview that is none, such as a user's own picture.
void requirePreview(const std::filesystem::path& png) {
  if (!std::filesystem::is_regular_file(png)) return;
  std::map<std::string, std::string> text;
  try {
    text = readPhotograph(png, {true}).text;
  } catch (const std::runtime_error& error) {
    refuseFile(error.what());
  }
  // Of our pictures only previews say at which exposure they were developed.
  if (!text["Software"].starts_with("parhelion") || !text.contains("Exposure"))
    refuseFile(png.string() + ": is no preview of parhelion");
}

/// Why the file is not the picture of the scene with all its rays; empty if it is.
std::string lackOf(const std::filesystem::path& exr, const LoadedScene& loaded) {
  if (!std::filesystem::exists(exr)) return "not there yet";
  const ExrAttributes found = pictureAttributes(exr), wanted = sceneAttributes(loaded, loaded.scene.trace.rays);
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
  return {};
}

}  // namespace

FrameNames::FrameNames(const std::string& pattern) {
  const std::string expected = "expected one number such as %04d in the name, for one frame_%04d.exr";
  bool numbered = false;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    std::string& part = numbered ? after_ : before_;
    if (pattern[i] != '%' || pattern.substr(i, 2) == "%%") {
      part += pattern[i];
      if (pattern[i] == '%') ++i;
      continue;
    }
    // %d, or %0 and the number of digits and d
    const std::size_t end = pattern.find_first_not_of("0123456789", i + 1);
    const std::string digits = end == std::string::npos ? "" : pattern.substr(i + 1, end - i - 1);
    const bool padded = digits.size() == 2 && digits[0] == '0';
    if (numbered || end == std::string::npos || pattern[end] != 'd' || !(digits.empty() || padded))
      refusePattern(pattern, expected + "; write %% for a percent sign");
    if (padded) digits_ = static_cast<std::size_t>(digits[1] - '0');
    numbered = true;
    i = end;
  }
  if (!numbered) refusePattern(pattern, expected);
  if (!after_.ends_with(".exr")) refusePattern(pattern, "frames are .exr, each with a .png beside it");
}

std::filesystem::path FrameNames::operator()(std::size_t number) const {
  const std::string digits = std::to_string(number);
  return before_ + std::string(digits.size() < digits_ ? digits_ - digits.size() : 0, '0') + digits + after_;
}

std::string SweepFrame::valuesText() const {
  std::string text;
  for (const std::string& value : values) text += (text.empty() ? "" : ", ") + value;
  return text;
}

std::vector<SweepFrame> planFrames(const RunOptions& run, std::span<const std::vector<std::string>> values,
                                   const FrameNames& names, std::size_t first) {
  std::vector<SweepFrame> frames;
  for (const std::vector<std::string>& overrides : values) {
    RunOptions one = run;
    one.overrides.insert(one.overrides.end(), overrides.begin(), overrides.end());
    frames.push_back({overrides, one.load(), names(first + frames.size()), {}});
  }
  for (SweepFrame& frame : frames) {
    frame.lacks = lackOf(frame.exr, frame.loaded);
    requirePreview(frame.png());
  }
  return frames;
}

}  // namespace parhelion::cli
