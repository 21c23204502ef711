// SPDX-License-Identifier: Apache-2.0
// A scene, and behind a zero byte overrides, a line each. What is accepted describes itself, can be traced, and its
// text with the overrides in it gives the same scene again.
#include <string>
#include <string_view>
#include <vector>

#include "input_file.h"
#include "render/traced_sky.h"
#include "scene/camera_override.h"
#include "scene/describe.h"
#include "scene/parse_scene.h"
#include "scene/scene_halos.h"
#include "scene/traced_keys.h"
#include "scene/view_difference.h"

namespace {

using namespace parhelion;

std::vector<std::string> linesOf(std::string_view text) {
  constexpr std::size_t kMostLines = 8;
  std::vector<std::string> lines;
  while (!text.empty() && lines.size() < kMostLines) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

void requireSame(const Scene& scene, const Scene& again) {
  require(talliedKeys(scene, scene.trace) == talliedKeys(again, again.trace));
  require(describeScene(scene) == describeScene(again));
  require(differencesOfView(scene, again).empty());
}

void use(const LoadedScene& loaded) {
  describeScene(loaded.scene);
  halosOf(loaded.scene.populations);
  requireSame(loaded.scene, parseScene(loaded.text, "again").scene);
  const std::vector<std::string> camera{cameraOverride(loaded.scene.camera)};
  parseScene(loaded.text, "with the camera", camera);
  constexpr std::size_t kFewPopulations = 8;  // the crystals of each take time
  if (loaded.scene.populations.size() <= kFewPopulations) chosenSettings(cloudOf(loaded.scene), loaded.scene.trace);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const Limits limits;
  const std::string_view all(reinterpret_cast<const char*>(data), size);
  const std::size_t end = all.find('\0');
  std::vector<std::string> overrides;
  if (end != std::string_view::npos) overrides = linesOf(all.substr(end + 1));
  std::optional<LoadedScene> loaded;
  try {
    loaded = parseScene(all.substr(0, end), "scene", overrides);
  } catch (const SceneError&) {
    return 0;
  }
  use(*loaded);
  return 0;
}
