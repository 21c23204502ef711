// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include "scene/scene_keys.h"
#include "sky/sky_tally.h"

namespace parhelion {

namespace {

constexpr const char* kAll = "all";

}  // namespace

bool kinds::Orders::read(const Value& in, int& out) const {
  if (in.string() == kAll) {
    out = SlabSettings::kAllOrders;
    return true;
  }
  const auto number = in.node.value_exact<std::int64_t>();
  if (!number || *number < 1 || *number > kMostOrders)
    return in.mustBe("a whole number from 1 to " + std::to_string(kMostOrders) + " or \"all\"");
  out = static_cast<int>(*number);
  return true;
}

Json kinds::Orders::schema() const {
  return {{"anyOf", {{{"type", "integer"}, {"minimum", 1}, {"maximum", kMostOrders}}, {{"enum", {kAll}}}}}};
}

bool kinds::Phase::read(const Value& in, PhaseTable& out) const {
  constexpr Range kDegrees{0, 180}, kValues{0, 1e30};
  const toml::array* list = in.node.as_array();
  const auto complain = [&] {
    return in.mustBe(
        "a list of two or more [angle, value], angles growing from 0 to 180 degrees, values not negative, or the name "
        "of a .csv file");
  };
  if (!list || list->size() < 2) return complain();
  double sum = 0.0;
  for (const toml::node& node : *list) {
    const toml::array* pair = node.as_array();
    if (!pair || pair->size() != 2) return complain();
    const auto angle = Value{*pair->get(0), in.key, in.complaints}.numberIn(kDegrees),
               value = Value{*pair->get(1), in.key, in.complaints}.numberIn(kValues);
    if (!angle || !value || (out.angles.empty() ? *angle != 0.0 : !(radians(*angle) > out.angles.back())))
      return complain();
    out.angles.push_back(radians(*angle));
    out.values.push_back(*value);
    sum += *value;
  }
  if (out.angles.back() != radians(180.0) || !(sum > 0.0)) return complain();
  return true;
}

Json kinds::Phase::schema() const {
  const Json pair = {
      {"type", "array"}, {"minItems", 2}, {"maxItems", 2}, {"items", {{"type", "number"}, {"minimum", 0}}}};
  const Json list = {{"type", "array"}, {"minItems", 2}, {"items", pair}};
  return {{"anyOf", {list, {{"type", "string"}, {"pattern", "\\.csv$"}}}}};
}

bool kinds::SlabLayers::read(const Value& in, std::vector<SlabLayer>& out) const {
  const toml::array* list = in.node.as_array();
  if (!list || list->empty())
    return in.mustBe("a list of tables", "begin each layer with [[cloud.layer]], in double brackets");
  if (list->size() > kMostLayers)
    return in.reject(std::to_string(list->size()) + " layers are too many; at most " + std::to_string(kMostLayers));
  bool isWhole = true;
  for (const toml::node& node : *list) {
    const toml::table* table = node.as_table();
    if (!table) return Value{node, in.key, in.complaints}.mustBe("a list of tables");
    TableReader reader(*table, "[[cloud.layer]]", in.complaints);
    SlabLayerKeys keys;
    visitKeys(reader, keys);
    isWhole = reader.rejectUnknown() && isWhole;
    for (const auto& [key, hint] :
         {std::pair("populations", "populations = [\"plates\"]"), std::pair("optical_depth", "optical_depth = 0.3")}) {
      if (!reader.has(key))
        in.complaints.add(placeOf(node.source(), in.complaints), std::string("a layer of a cloud needs '") + key + "'",
                          hint);
      isWhole = isWhole && reader.has(key) && !reader.rejected(key);
    }
    out.push_back({keys.populations, keys.opticalDepth.value_or(0.0)});
  }
  return isWhole;
}

Json kinds::SlabLayers::schema() const {
  Json layer = tableSchema<SlabLayerKeys>();
  layer["required"] = {"populations", "optical_depth"};
  return {{"type", "array"}, {"minItems", 1}, {"maxItems", kMostLayers}, {"items", layer}};
}

bool kinds::Slab::read(const Value& in, std::optional<SlabSettings>& out) const {
  const toml::table* table = in.node.as_table();
  if (!table) return in.mustBe("a table");
  TableReader reader(*table, "[cloud]", in.complaints);
  SlabKeys keys;
  visitKeys(reader, keys);
  const bool isKnown = reader.rejectUnknown();
  for (const char* key : {"optical_depth", "orders", "layer", "altitude"})
    if (!isKnown || reader.rejected(key)) return false;
  if (keys.opticalDepth && !keys.layers.empty()) {
    reader.reject("optical_depth", "'optical_depth' cannot be used together with [[cloud.layer]]",
                  "each layer has its own");
    return false;
  }
  if (!keys.opticalDepth && keys.layers.empty()) {
    in.complaints.add(placeOf(in.node.source(), in.complaints), "[cloud] needs an 'optical_depth'",
                      "the vertical one, by the shadows of the crystals: optical_depth = 0.3");
    return false;
  }
  double sum = 0.0;
  for (const SlabLayer& layer : keys.layers) sum += layer.opticalDepth;
  out = SlabSettings{keys.opticalDepth.value_or(sum), keys.orders, std::move(keys.layers), keys.altitude};
  return true;
}

Json kinds::Slab::schema() const { return tableSchema<SlabKeys>(); }

}  // namespace parhelion
