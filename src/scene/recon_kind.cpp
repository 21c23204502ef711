// SPDX-License-Identifier: Apache-2.0
#include <string>

#include "scene/scene_keys.h"

namespace parhelion {

namespace {

void rejectKeysOfOthers(TableReader& reader, const ReconSettings& chosen) {
  const KeysOfChosen keys = keysOfChosen(chosen);
  std::string list;
  for (const std::string_view name : keys.own) list += (list.empty() ? "" : ", ") + std::string(name);
  for (const std::string_view key : keys.others) {
    if (!reader.has(key)) continue;
    reader.reject(key, std::string("the method \"").append(nameOf(chosen)) + "\" has no '" + std::string(key) + "'",
                  list.empty() ? "it has no settings" : "its settings: " + list);
  }
}

}  // namespace

bool kinds::Recon::read(const Value& in, ReconSettings& out) const {
  const toml::table* table = in.node.as_table();
  if (!table) return in.mustBe("a table");
  TableReader reader(*table, "[recon]", in.complaints);
  visitKeys(reader, out);
  reader.rejectUnknown();
  if (reader.rejected("method")) return false;  // which keys it may have depends on it
  rejectKeysOfOthers(reader, out);
  if (const auto* act = std::get_if<ActSettings>(&out); act && act->iterations == 0)
    reader.reject("iterations", "the method \"act\" needs at least 1 iteration: it starts from an even grey");
  return true;
}

Json kinds::Recon::schema() const { return tableSchema<ReconSettings>(); }

}  // namespace parhelion
