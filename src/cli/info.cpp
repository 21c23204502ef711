// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "cli/commands.h"
#include "picture/exr.h"
#include "render/scene_attributes.h"
#include "scene/describe.h"
#include "scene/parse_scene.h"

namespace parhelion::cli {

namespace {

struct InfoOptions {
  std::string file;
  bool sceneOnly = false;
};

void printChannel(const Channel& channel) {
  float least = INFINITY, greatest = -INFINITY;
  double sum = 0.0;
  for (const float sample : channel.samples) {
    least = std::min(least, sample);
    greatest = std::max(greatest, sample);
    sum += sample;
  }
  std::printf("channel %-12s min %-12g mean %-12g max %g\n", channel.name.c_str(), least,
              sum / static_cast<double>(channel.samples.size()), greatest);
}

int infoExr(const InfoOptions& options) {
  const ExrFile exr = readExr(options.file, ExrColours::asStored);
  const auto scene = exr.attributes.find(kSceneKey);
  if (options.sceneOnly) {
    if (scene == exr.attributes.end()) throw std::runtime_error(options.file + ": holds no scene");
    std::fputs(scene->second.c_str(), stdout);
    return kDone;
  }
  std::printf("%s: EXR, %d x %d\n", options.file.c_str(), exr.image.width, exr.image.height);
  for (const Channel& channel : exr.image.channels) printChannel(channel);
  for (const auto& [key, value] : exr.attributes)
    if (key != kSceneKey) std::printf("%s: %s\n", key.c_str(), value.c_str());
  if (scene != exr.attributes.end()) {
    std::printf("made from the scene (print it with --scene):\n");
    std::fputs(describeScene(parseScene(scene->second, options.file).scene).c_str(), stdout);
  }
  return kDone;
}

int runInfo(const InfoOptions& options) {
  if (isExr(options.file)) return infoExr(options);
  const LoadedScene loaded = loadScene(options.file);
  std::fputs((options.sceneOnly ? loaded.text : describeScene(loaded.scene)).c_str(), stdout);
  return kDone;
}

}  // namespace

void addInfo(CLI::App& app, int& exit) {
  auto options = std::make_shared<InfoOptions>();
  CLI::App* command = app.add_subcommand("info", "Say what a scene file or an EXR holds");
  command->add_option("file", options->file, "A scene file, a picture or a tally")->required()->type_name("FILE");
  command->add_flag("--scene", options->sceneOnly, "Print only the scene's text, ready to be rendered again");
  command->callback([options, &exit] { exit = runInfo(*options); });
}

}  // namespace parhelion::cli
