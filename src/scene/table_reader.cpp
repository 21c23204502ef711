// SPDX-License-Identifier: Apache-2.0
#include "scene/table_reader.h"

#include <algorithm>

#include "scene/schema.h"
#include "scene/suggest.h"
#include "scene/utf8.h"

namespace parhelion {

void TableReader::reject(std::string_view name, const std::string& message, const std::string& hint) {
  Value{*table_.get(name), name, complaints_}.reject(message, hint);
}

void TableReader::rejectUnknown() {
  std::vector<std::string_view> sorted = accepted_;
  std::sort(sorted.begin(), sorted.end());
  std::string list;
  for (const std::string_view name : sorted) list += (list.empty() ? "" : ", ") + std::string(name);

  for (const auto& [key, node] : table_) {
    if (std::binary_search(sorted.begin(), sorted.end(), key.str())) continue;
    std::string hint = didYouMean(key.str(), sorted);
    const std::string homes = tablesWithKey(key.str());
    if (!homes.empty()) hint += (hint.empty() ? "" : " ") + std::string("it belongs to ") + homes + ";";
    hint += (hint.empty() ? "" : " ") + std::string("accepted: ") + list;
    const std::string where = title_.empty() ? "" : " in " + std::string(title_);
    complaints_.add(placeOf(key.source(), complaints_), "unknown key '" + printable(key.str(), 60) + "'" + where, hint);
  }
}

}  // namespace parhelion
