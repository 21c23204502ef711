// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>

#include "math/overloaded.h"
#include "scene/scene_keys.h"

namespace parhelion {

namespace {

OrientationSettings orientationNamed(OrientationName name, const PopulationKeys& keys) {
  const AngleDistribution tilt = keys.tilt.value_or(FixedValue{});
  const AngleDistribution free = AxisOrientation{}.roll;
  const AngleDistribution roll = keys.roll ? asTurn(*keys.roll) : free;
  const AngleDistribution horizontal = shifted(tilt, 0.5 * kPi);
  switch (name) {
    case OrientationName::random:
      return RandomOrientation{};
    case OrientationName::plate:
      return AxisOrientation{fromPole(tilt), free, roll};
    case OrientationName::column:
      return AxisOrientation{horizontal, free, roll};
    case OrientationName::parry:
      return AxisOrientation{horizontal, free, keys.roll ? roll : FixedValue{}};
    case OrientationName::lowitz:
      return LowitzOrientation{horizontal, roll};
  }
  return RandomOrientation{};
}

OrientationSettings orientationOf(const PopulationKeys& keys) {
  return std::visit(Overloaded{
                        [](const AxisOrientation& axis) -> OrientationSettings { return axis; },
                        [&](OrientationName name) { return orientationNamed(name, keys); },
                    },
                    keys.orientation);
}

/// "a", "b" or "c" of the shapes that have a key.
std::string shapesWith(std::string_view key) {
  std::string list;
  for (std::size_t i = 0; i < Family<PopulationShape>::size(); ++i) {
    const auto own = keysOfChosen(PopulationKeys{.shape = Family<PopulationShape>::member(i)}).own;
    if (std::find(own.begin(), own.end(), key) == own.end()) continue;
    list += (list.empty() ? "\"" : " or \"") + std::string(kNamesOf<PopulationShape>[i]) + '"';
  }
  return list;
}

/// Complains about a pyramid that is too thin or too long; false where it does.
bool checkLength(TableReader& reader, const PyramidSettings& pyramid) {
  const double length = lengthOverWidth(pyramid);
  const Range range{kThinnestAspect, kLongestAspect};
  if (range.contains(length)) return true;
  // With the other defaults no slope makes a crystal too thin, and none but a given one too long.
  reader.reject(
      length > kLongestAspect && reader.has("slope") ? "slope" : "aspect",
      "the crystal is " + formatNumber(length) + " times as long as wide; that must be a number " + range.text());
  return false;
}

/// "a prism"
std::string oneOf(const PopulationShape& shape) {
  if (std::holds_alternative<HazeWords>(shape)) return "haze";
  if (std::holds_alternative<PlanesSettings>(shape)) return "a crystal of planes";
  return "a " + std::string(nameOf(shape));
}

// What a crystal is made by. Of those that make none together, the first is said to be wrong.
constexpr std::array<std::string_view, 16> kShapeKeys{
    "cavity", "upper_cavity", "lower_cavity", "cap",   "upper_cap", "lower_cap", "notch",   "sides",
    "planes", "mesh",         "upper",        "lower", "overlap",   "slope",     "bullets", "aspect"};

/// Complains about shapes that enclose nothing, or are no closed surface.
void checkCrystal(TableReader& reader, const PopulationKeys& keys) {
  const auto crystal = crystalOf(keys.shape);
  const auto* prism = std::get_if<PrismSettings>(&keys.shape);
  const bool isCut = std::holds_alternative<RosetteSettings>(keys.shape) || (prism && !prism->isPlain()) ||
                     reader.has("sides") || reader.has("planes") || (crystal && !spreadsOf(*crystal).empty());
  if (!crystal || !isCut) return;
  try {
    static_cast<void>(meshOf(typicalShape(*crystal)));
  } catch (const std::invalid_argument& error) {
    for (const std::string_view key : kShapeKeys)
      if (reader.has(key)) return reader.reject(key, error.what());
  }
}

void checkShape(TableReader& reader, const PopulationKeys& keys) {
  if (reader.rejected("shape")) return;
  for (const std::string_view key : keysOfChosen(keys).others) {
    if (!reader.has(key)) continue;
    reader.reject(key, oneOf(keys.shape) + " has no '" + std::string(key) + "'", "it needs shape = " + shapesWith(key));
  }
  for (const std::string_view key : kShapeKeys)
    if (reader.rejected(key)) return;
  if (const auto* pyramid = std::get_if<PyramidSettings>(&keys.shape); pyramid && !checkLength(reader, *pyramid))
    return;
  const auto* haze = std::get_if<HazeWords>(&keys.shape);
  if (reader.has("phase") && !haze)
    reader.reject("phase", oneOf(keys.shape) + " has no 'phase'", "it needs shape = \"haze\"");
  if (haze && haze->g && keys.phase) reader.reject("g", "'g' cannot be used together with 'phase'");
  if (const auto* own = std::get_if<PlanesSettings>(&keys.shape); own && own->planes.empty())
    return reader.reject("shape", "a crystal of planes needs 'planes'",
                         "planes = [{ normal = [0, 0, 1], distance = 1 }, …]");
  if (const auto* own = std::get_if<MeshSettings>(&keys.shape); own && !own->crystal)
    return reader.reject("shape", "a crystal of this shape needs a 'mesh'", "mesh = \"crystal.obj\"");
  checkCrystal(reader, keys);
}

/// Why an orientation has neither tilt nor roll of its own, and what to do about it; nothing where it has.
struct NoSpread {
  std::string reason, hint;
};
std::optional<NoSpread> noSpreadOf(const OrientationWords& orientation) {
  return std::visit(
      Overloaded{
          [](OrientationName name) -> std::optional<NoSpread> {
            if (name != OrientationName::random) return std::nullopt;
            return NoSpread{"means nothing with the orientation \"random\"",
                            "choose \"plate\", \"column\", \"parry\" or \"lowitz\""};
          },
          [](const AxisOrientation&) -> std::optional<NoSpread> {
            return NoSpread{"cannot be used with an orientation in full", "put it into the orientation's table"};
          },
      },
      orientation);
}

void checkOrientation(TableReader& reader, const PopulationKeys& keys) {
  if (std::holds_alternative<HazeWords>(keys.shape)) {
    for (const std::string_view key : {"orientation", "tilt", "roll", "size", "distortion", "diffraction"})
      if (reader.has(key)) reader.reject(key, "haze has no '" + std::string(key) + "'", "leave it out");
    return;
  }
  if (reader.rejected("orientation")) return;
  const std::optional<NoSpread> none = noSpreadOf(keys.orientation);
  if (!none) return;
  for (const std::string_view key : {"tilt", "roll"})
    if (reader.has(key)) reader.reject(key, std::string("'").append(key) + "' " + none->reason, none->hint);
}

PhaseSettings phaseOf(const HazeWords& haze, const std::optional<PhaseTable>& table) {
  if (table) return *table;
  return HenyeyGreenstein{haze.g.value_or(HenyeyGreenstein{}.g)};
}

/// Puts one more into a scene and returns its name.
std::string readPopulation(TableReader& reader, std::size_t index, Scene& scene) {
  PopulationKeys keys;
  visitKeys(reader, keys);
  reader.rejectUnknown();
  checkShape(reader, keys);
  checkOrientation(reader, keys);
  const std::string name = keys.name.value_or(std::string("population ").append(std::to_string(index + 1)));
  std::visit(Overloaded{
                 [&](const HazeWords& haze) {
                   scene.hazes.push_back({name, keys.weight, phaseOf(haze, keys.phase)});
                 },
                 [&](const auto& shape) {
                   scene.populations.push_back(
                       {name, keys.weight, shape, orientationOf(keys), keys.size, keys.distortion, keys.diffraction});
                 },
             },
             keys.shape);
  return name;
}

}  // namespace

bool kinds::Populations::read(const Value& in, Scene& out) const {
  const toml::array* list = in.node.as_array();
  if (!list) return in.mustBe("a list of tables", "begin each population with [[population]], in double brackets");
  if (list->empty()) return in.reject("a scene needs at least one population");

  std::set<std::string> names;
  bool anyWeight = false;
  for (const toml::node& node : *list) {
    const toml::table* table = node.as_table();
    if (!table) return Value{node, in.key, in.complaints}.mustBe("a list of tables");
    TableReader reader(*table, "[[population]]", in.complaints);
    const std::string name = readPopulation(reader, out.populations.size() + out.hazes.size(), out);
    const bool isCrystals = !out.populations.empty() && out.populations.back().name == name;
    anyWeight = anyWeight || (isCrystals && out.populations.back().weight > 0.0) || reader.rejected("weight");
    const bool isNew = names.insert(name).second;
    const std::string message = "the name of this population is taken: \"" + name + '"';
    if (!isNew) Value{reader.has("name") ? *table->get("name") : node, in.key, in.complaints}.reject(message);
  }
  if (out.populations.empty())
    return in.reject("a scene needs a population of crystals", "haze stands beside them, for one with a weight of 1e6");
  if (!anyWeight) return in.reject("all populations have the weight 0; at least one must have more");
  return true;
}

Json kinds::Populations::schema() const {
  return {{"type", "array"}, {"minItems", 1}, {"items", tableSchema<PopulationKeys>()}};
}

bool kinds::Orientation::read(const Value& in, OrientationWords& out) const {
  if (const toml::table* table = in.node.as_table()) {
    TableReader reader(*table, "the orientation", in.complaints);
    AxisKeys keys;
    visitKeys(reader, keys);
    reader.rejectUnknown();
    if (!reader.has("zenith")) return in.reject("an orientation in full needs 'zenith', the c axis' zenith angle");
    out = AxisOrientation{keys.zenith.value_or(FixedValue{}), keys.azimuth, keys.roll};
    return true;
  }
  if (const auto name = memberNamedBy<OrientationName>(in)) {
    out = *name;
    return true;
  }
  const auto& names = kNamesOf<OrientationName>;
  return in.mustBe(std::string("one of ").append(listNames(names)) + " or { zenith = …, azimuth = …, roll = … }",
                   didYouMean(in.string().value_or(""), names));
}

Json kinds::Orientation::schema() const {
  Json table = tableSchema<AxisKeys>();
  table["required"] = {"zenith"};
  return {{"anyOf", {kinds::Choice<OrientationName>{}.schema(), table}}};
}

Json kinds::Orientation::write(const OrientationWords& value) const {
  return std::visit(Overloaded{
                        [](OrientationName name) { return Json(nameOf(name)); },
                        [](const AxisOrientation&) { return Json(); },
                    },
                    value);
}

}  // namespace parhelion
