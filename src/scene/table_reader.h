// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "scene/value.h"

namespace parhelion {

/// Reads the keys of one table as visitKeys() names them, and then complains about all others.
class TableReader {
 public:
  /// `title` is what messages call the table: "[sun]".
  TableReader(const toml::table& table, std::string_view title, Complaints& complaints)
      : table_(table), title_(title), complaints_(complaints) {}

  /// Fills `value` where the table has the key; otherwise it keeps its default. See kinds.h for Kind.
  template <class Kind, class T>
  void key(std::string_view name, const Kind& kind, T& value, std::string_view /*documentation*/) {
    accepted_.push_back(name);
    const toml::node* node = table_.get(name);
    if (node && !kind.read(Value{*node, name, complaints_}, value)) rejected_.insert(name);
  }

  bool has(std::string_view name) const { return table_.contains(name); }
  bool rejected(std::string_view name) const { return rejected_.contains(name); }

  /// Complains at the value of a key that the table has.
  void reject(std::string_view name, const std::string& message, const std::string& hint = "");

  /// Complains about the keys that nobody has asked for; false where there are some.
  bool rejectUnknown();

 private:
  const toml::table& table_;
  std::string_view title_;
  Complaints& complaints_;
  std::vector<std::string_view> accepted_;
  std::set<std::string_view> rejected_;
};

}  // namespace parhelion
