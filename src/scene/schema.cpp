// SPDX-License-Identifier: Apache-2.0
#include "scene/schema.h"

#include "scene/scene_keys.h"

namespace parhelion {

namespace {

Json schemaOfScenes() {
  Json schema = {{"$schema", "http://json-schema.org/draft-04/schema#"}, {"title", "Parhelion scene"}};
  schema.update(tableSchema<Scene>());
  schema["required"] = {"population"};
  return schema;
}

const Json& tables() {
  static const Json kTables = schemaOfScenes()["properties"];
  return kTables;
}

}  // namespace

std::string sceneSchema() { return schemaOfScenes().dump(2) + '\n'; }

std::string tablesWithKey(std::string_view key) {
  std::string list;
  for (const auto& [name, table] : tables().items()) {
    if (!table.contains("type")) continue;  // a plain value
    const bool isList = table["type"] == "array";
    const Json& properties = (isList ? table["items"] : table)["properties"];
    if (!properties.contains(std::string(key))) continue;
    const std::string title = isList ? "[[" + name + "]]" : "[" + name + "]";
    list += (list.empty() ? "" : " or ") + title;
  }
  return list;
}

bool isTable(std::string_view name) { return tables().contains(std::string(name)); }

}  // namespace parhelion
