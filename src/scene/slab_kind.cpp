// SPDX-License-Identifier: Apache-2.0
#include "scene/scene_keys.h"

namespace parhelion {

bool kinds::FirstOrder::read(const Value& in, int& out) const {
  if (in.node.value_exact<std::int64_t>() != 1) return in.mustBe("1: light is followed to its first scattering only");
  out = 1;
  return true;
}

Json kinds::FirstOrder::schema() const { return {{"const", 1}}; }

bool kinds::Slab::read(const Value& in, std::optional<SlabSettings>& out) const {
  const toml::table* table = in.node.as_table();
  if (!table) return in.mustBe("a table");
  TableReader reader(*table, "[cloud]", in.complaints);
  SlabKeys keys;
  visitKeys(reader, keys);
  if (!reader.rejectUnknown() || reader.rejected("optical_depth")) return false;
  if (!keys.opticalDepth) {
    in.complaints.add(placeOf(in.node.source(), in.complaints), "[cloud] needs an 'optical_depth'",
                      "the vertical one, by the shadows of the crystals: optical_depth = 0.3");
    return false;
  }
  out = SlabSettings{*keys.opticalDepth};
  return true;
}

Json kinds::Slab::schema() const { return tableSchema<SlabKeys>(); }

}  // namespace parhelion
