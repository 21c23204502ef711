// SPDX-License-Identifier: Apache-2.0
#include <set>
#include <string>
#include <type_traits>

#include "scene/scene_keys.h"

namespace parhelion {

namespace {

/// A spread about 0 moved to `mean` (rad). About the vertical, a uniform tilt is one-sided: a zenith angle is positive.
AngleDistribution movedTo(double mean, AngleDistribution spread) {
  std::visit(
      [mean](auto& d) {
        using D = std::decay_t<decltype(d)>;
        if constexpr (std::is_same_v<D, FixedValue>) {
          d.value += mean;
        } else if constexpr (std::is_same_v<D, UniformRange>) {
          d = mean == 0.0 ? UniformRange{0.0, d.to} : UniformRange{mean + d.from, mean + d.to};
        } else {
          d.mean += mean;
        }
      },
      spread);
  return spread;
}

/// A roll does not know solid angles: the two normal distributions are one.
AngleDistribution asTurn(const AngleDistribution& spread) {
  const auto* polar = std::get_if<PolarNormal>(&spread);
  return polar ? AngleDistribution(Normal{polar->mean, polar->sigma}) : spread;
}

OrientationSettings orientationOf(const PopulationKeys& keys) {
  if (const auto* axis = std::get_if<AxisOrientation>(&keys.orientation)) return *axis;
  const AngleDistribution tilt = keys.tilt.value_or(FixedValue{});
  const AngleDistribution free = AxisOrientation{}.roll;
  const AngleDistribution roll = keys.roll ? asTurn(*keys.roll) : free;
  const AngleDistribution horizontal = movedTo(0.5 * kPi, tilt);
  switch (std::get<OrientationName>(keys.orientation)) {
    case OrientationName::random:
      return RandomOrientation{};
    case OrientationName::plate:
      return AxisOrientation{movedTo(0.0, tilt), free, roll};
    case OrientationName::column:
      return AxisOrientation{horizontal, free, roll};
    case OrientationName::parry:
      return AxisOrientation{horizontal, free, keys.roll ? roll : FixedValue{}};
    case OrientationName::lowitz:
      return LowitzOrientation{horizontal, roll};
  }
  return RandomOrientation{};
}

ShapeSettings shapeOf(const PopulationKeys& keys) {
  if (keys.shape == ShapeName::prism) return PrismSettings{keys.aspect};
  PyramidSettings pyramid = keys.pyramid;
  if (const auto* aspect = std::get_if<FixedValue>(&keys.aspect)) pyramid.aspect = aspect->value;
  return pyramid;
}

void checkShape(TableReader& reader, const PopulationKeys& keys) {
  if (reader.rejected("shape")) return;
  for (const std::string_view key : {"upper", "lower", "slope"}) {
    if (keys.shape == ShapeName::pyramid || !reader.has(key)) continue;
    reader.reject(key, std::string("a prism has no '").append(key) + "'", "it needs shape = \"pyramid\"");
  }
  const auto* aspect = std::get_if<FixedValue>(&keys.aspect);
  const bool isFlat = aspect && aspect->value == 0.0 && keys.pyramid.upper == 0.0 && keys.pyramid.lower == 0.0;
  if (isFlat && keys.shape == ShapeName::pyramid) {
    reader.reject("aspect", "a crystal without a prism part and without pyramids is flat");
  }
}

void checkOrientation(TableReader& reader, const PopulationKeys& keys) {
  if (reader.rejected("orientation")) return;
  const auto* name = std::get_if<OrientationName>(&keys.orientation);
  if (name && *name != OrientationName::random) return;
  for (const std::string_view key : {"tilt", "roll"}) {
    if (!reader.has(key)) continue;
    const std::string quoted = std::string("'").append(key) + "'";
    if (name) {
      reader.reject(key, quoted + " means nothing with the orientation \"random\"",
                    "choose \"plate\", \"column\", \"parry\" or \"lowitz\"");
    } else {
      reader.reject(key, quoted + " cannot be used with an orientation in full", "put it into the orientation's table");
    }
  }
}

PopulationSettings readPopulation(TableReader& reader, std::size_t index) {
  PopulationKeys keys;
  visitKeys(reader, keys);
  reader.rejectUnknown();
  checkShape(reader, keys);
  checkOrientation(reader, keys);
  const std::string name = keys.name.value_or(std::string("population ").append(std::to_string(index + 1)));
  return {name, keys.weight, shapeOf(keys), orientationOf(keys)};
}

}  // namespace

bool Populations::read(const Value& in, std::vector<PopulationSettings>& out) const {
  const toml::array* list = in.node.as_array();
  if (!list) return in.mustBe("a list of tables", "begin each population with [[population]], in double brackets");
  if (list->empty()) return in.reject("a scene needs at least one population");

  std::set<std::string> names;
  bool anyWeight = false;
  for (const toml::node& node : *list) {
    const toml::table* table = node.as_table();
    if (!table) return Value{node, in.key, in.complaints}.mustBe("a list of tables");
    TableReader reader(*table, "[[population]]", in.complaints);
    out.push_back(readPopulation(reader, out.size()));
    anyWeight = anyWeight || out.back().weight > 0.0 || reader.rejected("weight");
    const bool isNew = names.insert(out.back().name).second;
    const std::string message = "the name of this population is taken: \"" + out.back().name + '"';
    if (!isNew) Value{reader.has("name") ? *table->get("name") : node, in.key, in.complaints}.reject(message);
  }
  if (!anyWeight) return in.reject("all populations have the weight 0; at least one must have more");
  return true;
}

Json Populations::schema() const {
  return {{"type", "array"}, {"minItems", 1}, {"items", tableSchema<PopulationKeys>()}};
}

bool Orientation::read(const Value& in, OrientationWords& out) const {
  if (const toml::table* table = in.node.as_table()) {
    TableReader reader(*table, "the orientation", in.complaints);
    AxisKeys keys;
    visitKeys(reader, keys);
    reader.rejectUnknown();
    if (!reader.has("zenith")) return in.reject("an orientation in full needs 'zenith', the c axis' zenith angle");
    out = AxisOrientation{keys.zenith.value_or(FixedValue{}), keys.azimuth, keys.roll};
    return true;
  }
  if (const auto name = enumeratorNamed<OrientationName>(in.string())) {
    out = *name;
    return true;
  }
  const auto names = acceptedNames<OrientationName>();
  return in.mustBe(std::string("one of ").append(listNames(names)) + " or { zenith = …, azimuth = …, roll = … }",
                   didYouMean(in.string().value_or(""), names));
}

Json Orientation::schema() const {
  Json table = tableSchema<AxisKeys>();
  table["required"] = {"zenith"};
  return {{"anyOf", {Choice<OrientationName>{}.schema(), table}}};
}

Json Orientation::write(const OrientationWords& value) const {
  const auto* name = std::get_if<OrientationName>(&value);
  return name ? Json(nameOf(*name)) : Json();
}

}  // namespace parhelion
