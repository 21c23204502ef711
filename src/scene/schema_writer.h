// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <utility>

#include "scene/number_schema.h"

namespace parhelion {

/// Visits the keys of one table and writes its JSON Schema.
class SchemaWriter {
 public:
  template <class Kind, class T>
  void key(std::string_view name, const Kind& kind, const T& value, std::string_view documentation) {
    Json& entry = properties_[std::string(name)];
    entry = kind.schema();
    entry["description"] = documentation;
    if (Json written = kind.write(value); !written.is_null()) entry["default"] = std::move(written);
  }

  Json schema() const { return {{"type", "object"}, {"additionalProperties", false}, {"properties", properties_}}; }

 private:
  Json properties_;
};

/// The schema of a table with the keys of T and T's defaults.
template <class T>
Json tableSchema() {
  T defaults{};
  SchemaWriter writer;
  visitKeys(writer, defaults);
  return writer.schema();
}

}  // namespace parhelion
