// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <toml++/toml.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "math/range.h"
#include "scene/complaints.h"

namespace parhelion {

Place placeOf(const toml::source_region& region, const Complaints& complaints);

/// A value of the scene with its key, and where to complain about it.
struct Value {
  const toml::node& node;
  std::string_view key;
  Complaints& complaints;

  /// Complains at the value; returns false, so that readers can `return value.reject(…)`.
  bool reject(const std::string& message, const std::string& hint = "") const;

  /// "'key' must be `what`, not 250".
  bool mustBe(const std::string& what, const std::string& hint = "") const;

  /// The number in the range, an integer or not; nothing (and no complaint) for anything else.
  std::optional<double> numberIn(const Range& range) const;

  /// The numbers of a list, likewise, if it is one of `least` to `most` numbers in the range.
  std::optional<std::vector<double>> numbersIn(std::size_t least, std::size_t most, const Range& range) const;

  std::optional<std::string> string() const { return node.value_exact<std::string>(); }
  bool isNumber() const { return node.is_number(); }
};

}  // namespace parhelion
