// SPDX-License-Identifier: Apache-2.0
#include "scene/number_schema.h"

namespace parhelion {

Json numberSchema(const Range& range) {
  Json schema = {{"type", "number"}, {"minimum", roundToTwelveDigits(range.lo)}};
  if (range.loOpen) schema["exclusiveMinimum"] = true;
  if (range.hi == std::numeric_limits<double>::max()) return schema;
  schema["maximum"] = roundToTwelveDigits(range.hi);
  if (range.hiOpen) schema["exclusiveMaximum"] = true;
  return schema;
}

Json listSchema(const Json& items, std::size_t least, std::size_t most) {
  return {{"type", "array"}, {"items", items}, {"minItems", least}, {"maxItems", most}};
}

}  // namespace parhelion
