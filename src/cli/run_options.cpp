// SPDX-License-Identifier: Apache-2.0
#include "cli/run_options.h"

#include <cstdint>
#include <optional>

#include "cli/commands.h"
#include "cli/duration.h"
#include "cli/number_options.h"
#include "cli/outputs.h"
#include "cli/scene_input.h"
#include "math/number_text.h"
#include "picture/image.h"
#include "scene/suggest.h"

namespace parhelion::cli {

namespace {

/// Complains unless `text` is a number of rays such as 250k or 10M.
std::string validRays(const std::string& text) {
  try {
    parseRayCount(text);
    return {};
  } catch (const std::exception& error) {
    return expectedNot(error.what(), text);
  }
}

/// All words for the values of an enumeration, as help texts show them.
template <class E>
std::string choices() {
  std::string all;
  for (const std::string_view name : kNamesOf<E>) all += (all.empty() ? "" : "|") + std::string(name);
  return all;
}

/// Complains unless `text` is WIDTHxHEIGHT.
std::string validResolution(const std::string& text) {
  const std::size_t x = text.find('x');
  const auto isSide = [](std::optional<std::int64_t> side) { return side && *side >= 1 && *side <= kMaxImageSide; };
  const std::string_view all = text;
  if (x != std::string::npos && isSide(wholeNumberIn(all.substr(0, x))) && isSide(wholeNumberIn(all.substr(x + 1))))
    return {};
  return expectedNot("WIDTHxHEIGHT in pixels, up to " + std::to_string(kMaxImageSide) + " each, for one 1920x1080",
                     text);
}

}  // namespace

CLI::Validator fileOfKind(std::vector<std::string> extensions, std::string expected) {
  return CLI::Validator(
      [=](const std::string& text) -> std::string {
        const std::string small = CLI::detail::to_lower(text);
        for (const std::string& extension : extensions)
          if (small.ends_with(extension)) return {};
        return expectedNot("the name of a " + expected + " file", text);
      },
      "");
}

CLI::Validator oneOf(std::vector<std::string_view> accepted) {
  return CLI::Validator(
      [accepted](const std::string& text) -> std::string {
        std::string all;
        for (const std::string_view name : accepted) {
          if (name == text) return {};
          all += (all.empty() ? "" : ", ") + std::string(name);
        }
        const std::string hint = didYouMean(text, accepted);
        return expectedNot("one of " + all, text) + (hint.empty() ? "" : "; " + hint);
      },
      "");
}

void addOverrides(CLI::App& command, std::vector<std::string>& overrides) {
  command.add_option("-D", overrides, "Override a key of the scene, for one sun.elevation=25; may be repeated")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
}

void RunOptions::addTo(CLI::App& command, bool hasImage) {
  command.add_option("scene", scene, "The scene file")->required()->type_name("SCENE");
  addTracingTo(command, hasImage);
  if (!hasImage) return;
  command.add_option("--resolution", resolution, "Size of the picture in pixels")
      ->type_name("WxH")
      ->check(CLI::Validator(validResolution, ""));
  command.add_flag("--no-ground", noGround, "Leave out what lies below the horizon, as camera.horizon = \"cut\" does");
}

void RunOptions::addTracingTo(CLI::App& command, bool hasImage) {
  addOverrides(command, overrides);
  command.add_option("--rays", rays, "Incident rays, all wavelengths together; k, M, G and T are understood")
      ->type_name("N")
      ->check(CLI::Validator(validRays, ""));
  command.add_option("--seed", seed, "Seed of the random numbers")->type_name("N")->transform(wholeNumber());
  command.add_option("--engine", engine, "What finds the next face of a crystal; integral follows no rays")
      ->type_name(choices<Engine>())
      ->check(nameOfOne<Engine>());
  command.add_option("--sampler", sampler, "Where the numbers come from that rays are drawn from")
      ->type_name(choices<Sampler>())
      ->check(nameOfOne<Sampler>());
  if (hasImage)
    command.add_option("--symmetry", symmetry, "Symmetry of the sky to make use of")
        ->type_name(choices<Symmetry>())
        ->check(nameOfOne<Symmetry>());
  command.add_option("--paths", filter, "Keep only light of such raypaths, for one 3-5 or '22° halo'; as trace.filter")
      ->type_name("PATTERN");
  command.add_option("--time", timeLimit, "Stop after this time, for one 90s or 8h, whatever has been traced")
      ->type_name("TIME")
      ->transform(durationInSeconds(1e-3, 1e9));
  command.add_option("--nthreads", threads, "Threads; as many as there are processors when left out")
      ->type_name("N")
      ->transform(wholeNumber(1, kMostThreads));
  command.add_option("--simd", simd, "Vector registers to use; the picture is the same with all of them")
      ->type_name(choices<Simd>())
      ->check(nameOfOne<Simd>());
  command.add_flag("--quiet", quiet, "No progress and no ledger on stderr");
  command.add_option("--progress", progress, "Progress as lines of JSON, for farms")->check(oneOf({"auto", "json"}));
  command.add_option("--stats", stats, "Write the run's figures as JSON")->type_name("FILE");
  addOverwrite(command, overwrite);
}

LoadedScene RunOptions::load(const std::vector<std::string>& more) const {
  std::vector<SceneOverride> all = overridesOf(overrides);
  const auto add = [&](const char* option, const std::string& word, const char* key) {
    if (!word.empty()) all.push_back(overrideOf(option, word, key));
  };
  if (!rays.empty()) all.push_back(overrideOf("--rays", rays, "trace.rays", std::to_string(parseRayCount(rays))));
  if (!seed.empty()) all.push_back(overrideOf("--seed", seed, "trace.seed", seed));
  add("--engine", engine, "trace.engine");
  add("--sampler", sampler, "trace.sampler");
  add("--symmetry", symmetry, "trace.symmetry");
  add("--paths", filter, "trace.filter");
  if (!resolution.empty()) {
    std::string size = resolution;
    size.replace(size.find('x'), 1, ",");
    all.push_back(overrideOf("--resolution", resolution, "camera.resolution", "[" + size + "]"));
  }
  if (noGround) all.push_back(overrideOf("--no-ground", "", "camera.horizon", "'cut'"));
  for (SceneOverride& one : overridesOf(more)) all.push_back(std::move(one));
  if (!sceneText_) sceneText_ = sceneTextOf(scene);
  LoadedScene loaded = parseSceneOf(scene, *sceneText_, all);
  const Engine chosen = loaded.scene.trace.engine;
  if ((chosen == Engine::integral || chosen == Engine::mixed) && !mayIntegrate)
    throw Unfit("engine " + std::string(nameOf(chosen)) +
                ": it makes pictures (render), maps, profiles and tables of paths; all else takes rays, with another "
                "engine, such as "
                "auto");
  return loaded;
}

}  // namespace parhelion::cli
