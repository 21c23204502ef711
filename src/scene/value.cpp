// SPDX-License-Identifier: Apache-2.0
#include "scene/value.h"

#include "scene/utf8.h"

namespace parhelion {

namespace {

/// What the user wrote, in words.
std::string given(const toml::node& node) {
  if (const auto text = node.value_exact<std::string>())
    return std::string("the string \"").append(printable(*text, 40)) + '"';
  if (node.is_integer()) return std::to_string(*node.value<std::int64_t>());
  if (const auto number = node.value_exact<double>()) return formatNumber(*number);
  if (const auto flag = node.value_exact<bool>()) return *flag ? "true" : "false";
  if (node.is_table()) return "a table";
  if (node.is_array()) return "a list";
  if (node.is_date()) return "a date alone";
  return node.is_time() ? "a time alone" : "a date and time";
}

}  // namespace

Place placeOf(const toml::source_region& region, const Complaints& complaints) {
  Place place;
  if (region.path) place.text = complaints.textNamed(*region.path);
  place.line = static_cast<int>(region.begin.line);
  place.column = static_cast<int>(region.begin.column);
  place.endLine = static_cast<int>(region.end.line);
  place.endColumn = static_cast<int>(region.end.column);
  return place;
}

bool Value::reject(const std::string& message, const std::string& hint) const {
  complaints.add(placeOf(node.source(), complaints), message, hint);
  return false;
}

bool Value::mustBe(const std::string& what, const std::string& hint) const {
  return reject(std::string("'").append(key) + "' must be " + what + ", not " + given(node), hint);
}

std::optional<double> Value::numberIn(const Range& range) const {
  if (!node.is_number()) return std::nullopt;
  const std::optional<double> number = node.value<double>();
  return number && range.contains(*number) ? number : std::nullopt;
}

std::optional<std::vector<double>> Value::numbersIn(std::size_t least, std::size_t most, const Range& range) const {
  const toml::array* list = node.as_array();
  if (!list || list->size() < least || list->size() > most) return std::nullopt;
  std::vector<double> numbers;
  for (const toml::node& element : *list) {
    const auto number = Value{element, key, complaints}.numberIn(range);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

}  // namespace parhelion
