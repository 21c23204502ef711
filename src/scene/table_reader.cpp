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

bool TableReader::rejectUnknown() {
  std::vector<std::string_view> sorted = accepted_;
  std::sort(sorted.begin(), sorted.end());
  std::string list;
  for (const std::string_view name : sorted) list += (list.empty() ? "" : ", ") + std::string(name);

  bool good = true;
  for (const auto& [key, node] : table_) {
    if (std::binary_search(sorted.begin(), sorted.end(), key.str())) continue;
    good = false;
    std::string hint = didYouMean(key.str(), sorted);
    if (!hint.empty()) hint += ' ';
    const std::string homes = tablesWithKey(key.str());
    if (!homes.empty()) hint.append("it belongs to ").append(homes).append("; ");
    hint.append("accepted: ").append(list);
    const std::string where = title_.empty() ? "" : std::string(" in ").append(title_);
    complaints_.add(placeOf(key.source(), complaints_),
                    std::string("unknown key '").append(printable(key.str(), 60)) + "'" + where, hint);
  }
  return good;
}

}  // namespace parhelion
