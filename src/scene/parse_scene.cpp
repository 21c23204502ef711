// SPDX-License-Identifier: Apache-2.0
#include "scene/parse_scene.h"

#include <toml++/toml.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <system_error>

#include "crystal/symmetry.h"
#include "picture/file_reason.h"
#include "picture/limits.h"
#include "scene/index_files.h"
#include "scene/layer_checks.h"
#include "scene/mesh_files.h"
#include "scene/optics_checks.h"
#include "scene/overrides.h"
#include "scene/phase_files.h"
#include "scene/scene_keys.h"
#include "scene/text_guard.h"

namespace parhelion {

namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// The word at a place of the text that stands where a value is due; empty where there is none.
std::string_view wordForValue(std::string_view text, const Place& place) {
  for (int line = 1; line < place.line; ++line) text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
  const std::string_view line = text.substr(0, text.find('\n'));
  const auto at = static_cast<std::size_t>(std::max(place.column - 1, 0));
  if (at >= line.size() || !isLetter(line[at])) return {};
  const std::size_t before = line.substr(0, at).find_last_not_of(" \t");
  if (before == std::string_view::npos || std::string_view("=,[").find(line[before]) == std::string_view::npos)
    return {};
  return line.substr(at, line.find_first_of(" \t\r,]}#", at) - at);
}

/// What may have been meant by a text that is no TOML.
std::string hintForText(std::string_view text, std::string_view fileName, const Place& place) {
  const std::string kind = std::filesystem::path(fileName).extension().string();
  if (!kind.empty() && kind != ".toml")
    return "a scene is a TOML file; where this is a mesh or a table for one, a key of the scene names it";
  const std::string_view word = wordForValue(text, place);
  return word.empty() ? "" : "text stands in quotation marks: \"" + std::string(word) + '"';
}

toml::table parseToml(std::string_view text, std::string_view fileName, Complaints& complaints) {
  if (const auto problem = findTextProblem(text)) {
    const Place place{0, problem->line, problem->column, problem->line, problem->column + 1};
    const std::string hint = hintForText(text, fileName, place);
    complaints.add(place, problem->message, hint.empty() ? problem->hint : hint);
    complaints.throwIfAny();
  }
  try {
    return toml::parse(text, fileName);
  } catch (const toml::parse_error& e) {
    const Place place = placeOf(e.source(), complaints);
    complaints.add(place, std::string("not TOML: ").append(e.description()), hintForText(text, fileName, place));
  }
  complaints.throwIfAny();
  return {};
}

/// Complains where a symmetry is asked for that a population does not have.
void checkSymmetry(const toml::table& root, const Scene& scene, Complaints& complaints) {
  const bool mirror = scene.trace.symmetry == Symmetry::mirror, radial = scene.trace.symmetry == Symmetry::radial;
  if (!mirror && !radial) return;
  const auto* odd = firstWithout(mirror ? &isMirrorSymmetric : &isFullyRandom, scene.populations);
  const toml::node* node = root["trace"]["symmetry"].node();
  if (!odd || !node) return;
  complaints.add(placeOf(node->source(), complaints),
                 mirror ? "the population '" + odd->name + "' is not its own mirror image in the sun's vertical plane"
                        : "the population '" + odd->name + "' is not in random orientation",
                 "leave 'symmetry' out, and what can be used will be");
}

/// Turns an azimuth of the camera that counts from north into one that counts from the sun. Complains where the sun's
/// is not known.
void pointFromSun(const toml::table& root, Scene& scene, Complaints& complaints) {
  const toml::node* node = root["camera"]["azimuth_from"].node();
  if (!node || node->value_exact<std::string>() != nameOf(AzimuthFrom::north)) return;
  if (scene.sun.azimuth) {
    scene.camera.azimuth = std::remainder(scene.camera.azimuth - *scene.sun.azimuth, 2.0 * kPi);
    return;
  }
  if (root["sun"]["date"]) return;  // whatever is wrong with it has been said
  complaints.add(placeOf(node->source(), complaints), "where north is depends on the sun, whose azimuth is not known",
                 "give [sun] a date with latitude and longitude, or an azimuth beside its elevation");
}

/// Complains about what crystals that are not convex cannot do.
void checkConcave(const toml::table& root, const Scene& scene, Complaints& complaints) {
  const auto isConvex = [](const PopulationSettings& population) {
    try {
      return meshOf(typicalShape(population.shape)).isConvex();
    } catch (const std::invalid_argument&) {
      return true;  // of which has been complained
    }
  };
  const auto* odd = firstWithout(isConvex, scene.populations);
  if (!odd) return;
  const toml::node* engine = root["trace"]["engine"].node();
  if (engine && scene.trace.engine == Engine::planes)
    complaints.add(placeOf(engine->source(), complaints),
                   "the planes follow light in convex crystals of up to 32 faces, not in those of '" + odd->name + "'",
                   "leave 'engine' out, and Embree follows it");
}

/// Complains about light that is not the sun's where the air scatters it.
void checkAir(const toml::table& root, const Scene& scene, Complaints& complaints) {
  const toml::node* node = root["sun"]["spectrum"].node();
  const auto* light = std::get_if<ContinuousSpectrum>(&scene.sun.spectrum);
  if (!scene.sky.air || !node || (light && light->source == ContinuousSpectrum::Source::extraterrestrial)) return;
  complaints.add(placeOf(node->source(), complaints), "with 'sky.air' the sun has a spectrum of its own",
                 "leave 'spectrum' out, or say \"sun\"; the air reddens it by itself");
}

/// Complains about keys that change nothing where a scene says nothing of air. With `air = false` they wait for it.
void checkWithoutAir(const toml::table& root, Complaints& complaints) {
  if (root["sky"]["air"]) return;
  const auto complain = [&](const char* table, const char* key) {
    if (const toml::node* node = root[table][key].node())
      complaints.add(placeOf(node->source(), complaints),
                     std::string("'") + table + "." + key + "' changes nothing where there is no air",
                     "say air = true in [sky], or air = false to keep it for later");
  };
  for (const char* key : {"ozone", "aerosol", "ground"}) complain("sky", key);
  for (const char* table : {"observer", "cloud"}) complain(table, "altitude");
}

Scene readScene(const toml::table& root, Complaints& complaints) {
  Scene scene;
  TableReader reader(root, "", complaints);
  visitKeys(reader, scene);
  reader.rejectUnknown();
  if (!reader.has("population")) {
    complaints.add({}, "a scene needs at least one population", "begin each population with [[population]]");
  }
  pointFromSun(root, scene, complaints);
  checkSymmetry(root, scene, complaints);
  checkAir(root, scene, complaints);
  checkIndex(root, scene, complaints);
  checkOptics(root, scene, complaints);
  checkConcave(root, scene, complaints);
  checkWithoutAir(root, complaints);
  checkCloudLayers(root, scene, complaints);
  addLayerPerPopulation(root, scene, complaints);
  checkLayers(root, scene, complaints);
  return scene;
}

std::string serialised(const toml::table& root) {
  std::ostringstream out;
  out << root << '\n';
  return out.str();
}

[[noreturn]] void throwFileError(std::string_view fileName, const std::string& message) {
  throw SceneError({{std::string(fileName), 0, 0, message, "", ""}});
}

}  // namespace

std::string readSceneText(const std::filesystem::path& path) {
  std::error_code status;
  if (!std::filesystem::exists(path, status) && !status) {
    const std::string folder = missingFolderOf(path);
    throwFileError(path.string(), folder.empty() ? "no such file" : folder);
  }

  errno = 0;
  std::ifstream file(path, std::ios::binary);
  std::string text(kMostSceneBytes + 1, '\0');
  if (file) file.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (!file.eof() && !file.good()) {
    throw std::runtime_error(path.string() + ": " + reasonFor(path, errno != 0 ? errno : EIO));
  }
  text.resize(static_cast<std::size_t>(file.gcount()));
  return text;
}

LoadedScene loadScene(const std::filesystem::path& path, std::span<const std::string> overrides) {
  return parseScene(readSceneText(path), path.string(), overrides);
}

LoadedScene parseScene(std::string_view text, std::string_view fileName, std::span<const std::string> overrides) {
  return parseScene(text, fileName, overridesOf({overrides.begin(), overrides.end()}));
}

LoadedScene parseScene(std::string_view text, std::string_view fileName, std::span<const SceneOverride> overrides) {
  if (text.size() > kMostSceneBytes) throwFileError(fileName, "larger than 1 MiB: this is no scene file");
  const bool hasMark = text.starts_with(kByteOrderMark);
  const std::string_view body = text.substr(hasMark ? kByteOrderMark.size() : 0);

  Complaints complaints;
  complaints.addText(fileName, body);
  toml::table root = parseToml(body, fileName, complaints);
  for (const SceneOverride& override : overrides) applyOverride(root, override, complaints);
  const std::filesystem::path folder = std::filesystem::path(fileName).parent_path();
  const bool hasPhases = readPhaseFiles(root, folder, complaints), hasMeshes = readMeshFiles(root, folder, complaints),
             hasIndex = readIndexFile(root, folder, complaints);
  const Scene scene = readScene(root, complaints);
  complaints.throwIfAny();
  return {scene, overrides.empty() && !hasPhases && !hasMeshes && !hasIndex ? std::string(text) : serialised(root)};
}

}  // namespace parhelion
