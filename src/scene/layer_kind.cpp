// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <set>
#include <string>

#include "crystal/raypath/path_automaton.h"
#include "crystal/raypath/path_symmetry.h"
#include "crystal/raypath/stance.h"
#include "scene/layer_checks.h"
#include "scene/scene_keys.h"
#include "scene/utf8.h"
#include "sky/sky_tally.h"

namespace parhelion {

namespace {

constexpr Range kTiltRange{0, 180};

/// [from, to] in degrees.
bool readTilt(const Value& in, LayerSettings::TiltRange& out) {
  const toml::array* list = in.node.as_array();
  const auto number = [&](std::size_t i) {
    return list && list->size() == 2 ? Value{*list->get(i), in.key, in.complaints}.numberIn(kTiltRange) : std::nullopt;
  };
  const auto from = number(0), to = number(1);
  if (!from || !to || !(*from < *to)) return in.mustBe("[from, to], degrees from 0 to 180, from below to");
  out = {radians(*from), radians(*to)};
  return true;
}

/// A name that channels of a picture can have before their own: NAME.R
bool isLayerName(const std::string& name) {
  return name != kRestLayer && name.find_first_of("./\\") == std::string::npos && name.front() != ' ' &&
         name.back() != ' ';
}

LayerSettings readLayer(const toml::table& table, Complaints& complaints) {
  TableReader reader(table, "[[layer]]", complaints);
  LayerKeys keys;
  visitKeys(reader, keys);
  reader.rejectUnknown();
  if (!reader.has("name"))
    complaints.add(placeOf(table.source(), complaints), "a layer needs a name", "name = \"cza\"");
  else if (!reader.rejected("name") && !isLayerName(*keys.name))
    reader.reject("name", "a layer's name must not be \"rest\" nor have '.', '/', '\\' or a space at its ends");
  return {keys.name.value_or(""), keys.paths, keys.populations, keys.tilt, keys.order};
}

}  // namespace

bool kinds::Paths::read(const Value& in, PathPattern& out) const {
  auto text = in.string();
  if (const auto face = in.node.value_exact<std::int64_t>()) text = std::to_string(*face);  // 3: reflected by face 3
  if (!text || text->size() > kMostPatternBytes || printable(*text, text->size()) != *text)
    return in.mustBe("a pattern of raypaths, such as \"3-5\", or the name of a halo");
  try {
    out = parsePathPattern(*text);
    return true;
  } catch (const PatternError& error) {
    const Place whole = placeOf(in.node.source(), in.complaints);
    in.complaints.add(in.complaints.placeIn(whole, *text, error.at, error.length),
                      std::string("'").append(in.key) + "': " + error.what(),
                      didYouMean(error.unknownWord, error.acceptedWords));
    return false;
  }
}

bool kinds::Names::read(const Value& in, std::vector<std::string>& out) const {
  const toml::array* list = in.node.as_array();
  if (!list || list->empty()) return in.mustBe("a list of names, such as [\"plates\"]");
  for (const toml::node& node : *list) {
    std::string name;
    if (!Text{}.read(Value{node, in.key, in.complaints}, name)) return false;
    if (std::ranges::find(out, name) != out.end())
      return Value{node, in.key, in.complaints}.reject("this name is in the list already");
    out.push_back(std::move(name));
  }
  return true;
}

Json kinds::Names::schema() const {
  return {{"type", "array"}, {"minItems", 1}, {"uniqueItems", true}, {"items", Text{}.schema()}};
}

bool kinds::Tilts::read(const Value& in, LayerSettings::TiltRange& out) const { return readTilt(in, out); }

Json kinds::Tilts::schema() const {
  return {{"type", "array"}, {"minItems", 2}, {"maxItems", 2}, {"items", numberSchema(kTiltRange)}};
}

bool kinds::Layers::read(const Value& in, std::vector<LayerSettings>& out) const {
  const toml::array* list = in.node.as_array();
  if (!list) return in.mustBe("a list of tables", "begin each layer with [[layer]], in double brackets");
  if (list->size() > kMostLayers)
    return in.reject(std::to_string(list->size()) + " layers are too many; at most " + std::to_string(kMostLayers));
  std::set<std::string> names;
  for (const toml::node& node : *list) {
    const toml::table* table = node.as_table();
    if (!table) return Value{node, in.key, in.complaints}.mustBe("a list of tables");
    out.push_back(readLayer(*table, in.complaints));
    if (!out.back().name.empty() && !names.insert(out.back().name).second)
      Value{*table->get("name"), in.key, in.complaints}.reject("the name of this layer is taken: \"" + out.back().name +
                                                               '"');
  }
  return true;
}

Json kinds::Layers::schema() const {
  Json layer = tableSchema<LayerKeys>();
  layer["required"] = {"name"};
  return {{"type", "array"}, {"maxItems", kMostLayers}, {"items", layer}};
}

namespace {

/// Complains about names that no population has.
void checkNames(const std::vector<std::string>& names, const Scene& scene, const Place& place, Complaints& complaints) {
  std::vector<std::string_view> accepted;
  for (const PopulationSettings& population : scene.populations) accepted.push_back(population.name);
  for (const std::string& name : names)
    if (std::ranges::find(accepted, name) == accepted.end())
      complaints.add(place, "there is no population \"" + name + '"', didYouMean(name, accepted));
}

bool isNamed(const std::vector<std::string>& names, const std::string& name) {
  return names.empty() || std::ranges::find(names, name) != names.end();
}

int ordersOf(const Scene& scene) { return scene.cloud ? scene.cloud->orders : 1; }

/// Complains about light that a layer asks for and the scene does not have.
void checkOrder(const LayerSettings& layer, const Scene& scene, const Place& place, Complaints& complaints) {
  if (!layer.order) return;
  if (*layer.order > ordersOf(scene))
    complaints.add(place,
                   "this light is not in the picture: its light is scattered " +
                       (ordersOf(scene) == 1 ? std::string("once") : std::to_string(ordersOf(scene)) + " times") +
                       " at most",
                   "say orders = " + std::to_string(*layer.order) + " or more in [cloud]");
  if (*layer.order > 1 && (layer.paths || !layer.populations.empty() || layer.tilt))
    complaints.add(place, "light that was scattered more than once has no one path, population or tilt",
                   "leave these out of a layer with 'order'");
}

/// Whether a crystal of this mesh has the faces of some path that a pattern takes.
bool hasFacesFor(const PathPattern& pattern, const Population& population) {
  std::vector<int> numbers;
  for (const Face& face : population.mesh().faces()) numbers.push_back(face.number);
  const SymmetricPattern own[] = {
      {&pattern, pathSymmetries(population.mesh(), population.orientation(), pattern.symmetry)}};
  const PathAutomaton automaton(numbers, own);
  for (int state = 0; state < automaton.states(); ++state)
    if (state != PathAutomaton::kStart && automaton.accepted(state).any()) return true;
  return false;
}

/// Complains about a pattern whose faces no crystal has.
void checkFaces(const PathPattern& pattern, const std::vector<std::string>& populations, const Scene& scene,
                const Place& place, Complaints& complaints) {
  bool speaksOfSome = false;  // if not, that is complained about elsewhere
  for (const PopulationSettings& settings : scene.populations) {
    if (!isNamed(populations, settings.name) || !isNamed(pattern.populations, settings.name)) continue;
    speaksOfSome = true;
    const Population population(settings);
    if (hasFacesFor(pattern, population)) return;
    for (const PathPattern& other : pattern.others)
      if (hasFacesFor(other, population)) return;
  }
  if (!speaksOfSome) return;
  complaints.add(place, "no crystal here has the faces of '" + pattern.text + "'",
                 "prisms have the faces 1 to 8, pyramids also 13 to 18 and 23 to 28");
}

/// Complains about the name of a halo that none of the populations can make.
void checkStances(const PathPattern& pattern, const std::vector<std::string>& populations, const Scene& scene,
                  const Place& place, Complaints& complaints) {
  checkFaces(pattern, populations, scene, place, complaints);
  std::vector<Stance> stances = pattern.stances;
  if (stances.empty()) return;
  for (const PathPattern& other : pattern.others) {
    if (other.stances.empty()) return;
    stances.insert(stances.end(), other.stances.begin(), other.stances.end());
  }
  for (const PopulationSettings& settings : scene.populations) {
    if (!isNamed(populations, settings.name) || !isNamed(pattern.populations, settings.name)) continue;
    const auto stance = stanceOf(Population(settings));
    if (stance && std::ranges::find(stances, *stance) != stances.end()) return;
  }
  std::string needed;
  for (const Stance stance : stances) needed += (needed.empty() ? "\"" : " or \"") + std::string(nameOf(stance)) + '"';
  complaints.add(place, "no population here makes the halo of '" + pattern.text + "'",
                 "it comes of crystals whose orientation is " + needed);
}

}  // namespace

void checkLayers(const toml::table& root, Scene& scene, Complaints& complaints) {
  PathSettings& paths = scene.trace.paths;
  if (const toml::node* node = root["trace"]["filter"].node(); node && paths.filter) {
    if (ordersOf(scene) > 1)
      complaints.add(placeOf(node->source(), complaints),
                     "a filter keeps paths through one crystal, and light that was "
                     "scattered more than once has none",
                     "leave 'filter' out, or say orders = 1 in [cloud]");
    checkNames(paths.filter->populations, scene, placeOf(node->source(), complaints), complaints);
    checkStances(*paths.filter, {}, scene, placeOf(node->source(), complaints), complaints);
  }
  const toml::array* list = root["layer"].as_array();
  for (std::size_t i = 0; list && i < std::min(list->size(), paths.layers.size()); ++i) {
    const toml::table* table = list->get(i)->as_table();
    if (!table) continue;
    const auto placeOfKey = [&](std::string_view key) {
      const toml::node* node = table->get(key);
      return placeOf((node ? *node : static_cast<const toml::node&>(*table)).source(), complaints);
    };
    const LayerSettings& layer = paths.layers[i];
    checkOrder(layer, scene, placeOfKey("order"), complaints);
    checkNames(layer.populations, scene, placeOfKey("populations"), complaints);
    if (!layer.paths) continue;
    checkNames(layer.paths->populations, scene, placeOfKey("paths"), complaints);
    checkStances(*layer.paths, layer.populations, scene, placeOfKey("paths"), complaints);
  }
}

void checkCloudLayers(const toml::table& root, const Scene& scene, Complaints& complaints) {
  if (!scene.cloud || scene.cloud->layers.empty()) return;
  std::vector<std::string> names, taken;
  std::vector<double> weights;
  for (const PopulationSettings& population : scene.populations) {
    names.push_back(population.name);
    weights.push_back(population.weight);
  }
  for (const HazeSettings& haze : scene.hazes) {
    names.push_back(haze.name);
    weights.push_back(haze.weight);
  }
  const std::vector<std::string_view> accepted(names.begin(), names.end());
  const toml::array& list = *root["cloud"]["layer"].as_array();
  for (std::size_t i = 0; i < scene.cloud->layers.size(); ++i) {
    const Place place = placeOf(list.get(i)->as_table()->get("populations")->source(), complaints);
    double weight = 0.0;
    for (const std::string& name : scene.cloud->layers[i].populations) {
      taken.push_back(name);
      const auto found = std::ranges::find(names, name);
      if (found == names.end())
        complaints.add(place, "there is no population \"" + name + '"', didYouMean(name, accepted));
      weight += found == names.end() ? 1.0 : weights[static_cast<std::size_t>(found - names.begin())];
    }
    if (!(weight > 0.0)) complaints.add(place, "all populations of this layer have the weight 0");
  }
  for (const std::string& name : names)
    if (std::ranges::find(taken, name) == taken.end())
      complaints.add(placeOf(list.source(), complaints), "the population \"" + name + "\" is in no layer of the cloud",
                     "name it in 'populations' of a [[cloud.layer]]");
}

void addLayerPerPopulation(const toml::table& root, Scene& scene, Complaints& complaints) {
  const toml::node* node = root["layers"].node();
  const bool isOfCloud = !node && scene.cloud && !scene.cloud->layers.empty();
  if (isOfCloud) node = root["cloud"]["layer"].node();
  if (!node) return;
  const Place place = placeOf(node->source(), complaints);
  std::vector<LayerSettings>& layers = scene.trace.paths.layers;
  if (root.contains("layer")) {
    complaints.add(place,
                   std::string(isOfCloud ? "[[cloud.layer]]" : "'layers'") + " cannot be used together with [[layer]]",
                   isOfCloud ? "the picture has a layer for each population then" : "leave one of them out");
    return;
  }
  if (scene.populations.size() > kMostLayers) {
    complaints.add(place, std::to_string(scene.populations.size()) + " populations are too many layers; at most " +
                              std::to_string(kMostLayers));
    return;
  }
  for (const PopulationSettings& population : scene.populations) {
    if (!isLayerName(population.name))
      complaints.add(place, "the population's name \"" + population.name + "\" cannot be that of a layer",
                     "it must not be \"rest\" nor have '.', '/', '\\' or a space at its ends");
    layers.push_back({population.name, {}, {population.name}, {}, {}});
  }
}

}  // namespace parhelion
