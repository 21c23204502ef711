// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <utility>

#include "scene/value.h"

namespace parhelion {

/// Puts what files hold in the place of their names: of each population whose `key` is a text for which isName(text)
/// holds, what contents(name, place) makes of it, which is none where it has complained. Returns whether there was any
/// name. Throws as Complaints::throwIfAny().
template <class IsName, class Contents>
bool putFiles(toml::table& root, std::string_view key, const IsName& isName, const Contents& contents,
              Complaints& complaints) {
  bool any = false;
  toml::array* populations = root["population"].as_array();
  for (std::size_t i = 0; populations && i < populations->size(); ++i) {
    toml::table* population = (*populations)[i].as_table();
    const toml::node* node = population ? population->get(key) : nullptr;
    const auto name = node ? node->value_exact<std::string>() : std::nullopt;
    if (!name || !isName(*name)) continue;
    any = true;
    if (auto own = contents(*name, placeOf(node->source(), complaints)))
      population->insert_or_assign(key, std::move(*own));
  }
  complaints.throwIfAny();
  return any;
}

}  // namespace parhelion
