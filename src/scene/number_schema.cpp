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

}  // namespace parhelion
