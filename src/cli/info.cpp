// SPDX-License-Identifier: Apache-2.0
#include <filesystem>

#include "cli/commands.h"
#include "cli/info_photograph.h"
#include "cli/info_tally.h"
#include "cli/say.h"
#include "cli/scene_input.h"
#include "cli/tally_input.h"
#include "picture/exr.h"
#include "picture/file_kind.h"
#include "picture/picture_text.h"
#include "render/scene_attributes.h"
#include "scene/describe.h"
#include "scene/parse_scene.h"

namespace parhelion::cli {

namespace {

struct InfoOptions {
  std::string file;
  bool sceneOnly = false, edited = false;
};

int infoExr(const std::string& path, EditedPictures edited) {
  const ExrFrame exr = readExrFrame(path);
  answer("%s: EXR, %d x %d", path.c_str(), exr.width, exr.height);
  for (const ChannelRange& channel : readExrRanges(path, edited))
    answer("channel %-12s min %-12g mean %-12g max %g", shortened(channel.name).c_str(), channel.least, channel.mean,
           channel.greatest);
  printTexts(exr.attributes, path);
  return kDone;
}

/// Prints the scene that a picture or a tally carries. What would act on a terminal is escaped wherever it goes: no
/// scene has control characters, and in a string the escape stands for the same text.
int printScene(const std::string& path, const std::map<std::string, std::string>& text) {
  const auto scene = text.find(kSceneKey);
  if (scene == text.end()) throw std::runtime_error(path + ": holds no scene");
  answerLines(scene->second);
  return kDone;
}

int runInfo(const InfoOptions& options) {
  const FileKind kind = kindOf(startOfFile(options.file));
  if (kind.isPhotograph()) {
    if (options.sceneOnly) return printScene(options.file, readPictureText(options.file));
    if (isTallyFile(options.file)) return infoTally(options.file);
    const EditedPictures edited = options.edited ? EditedPictures::read : EditedPictures::refused;
    return kind.family == FileKind::Family::exr ? infoExr(options.file, edited) : infoPhotograph(options.file, kind);
  }
  const LoadedScene loaded = loadSceneOf(options.file);
  answerLines(options.sceneOnly ? loaded.text : describeScene(loaded.scene));
  return kDone;
}

}  // namespace

void addInfo(CLI::App& app, int& exit) {
  auto options = std::make_shared<InfoOptions>();
  CLI::App* command = app.add_subcommand("info", "Say what a scene, a picture, a tally or a photograph holds");
  command->add_option("file", options->file, "A scene file, a picture, a tally or a photograph")
      ->required()
      ->type_name("FILE");
  command->add_flag("--scene", options->sceneOnly, "Print only the scene's text, ready to be rendered again");
  command->add_flag("--edited", options->edited,
                    "Take an EXR of parhelion as it is, though another program has changed it");
  command->callback([options, &exit] { exit = runInfo(*options); });
}

}  // namespace parhelion::cli
