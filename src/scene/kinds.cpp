// SPDX-License-Identifier: Apache-2.0
#include "scene/kinds.h"

#include <algorithm>
#include <stdexcept>

#include "optics/solar_position.h"
#include "picture/image.h"
#include "scene/parse_scene.h"
#include "scene/utf8.h"

namespace parhelion::kinds {

namespace {

std::optional<std::int64_t> integerIn(const toml::node* node, std::int64_t lo, std::int64_t hi) {
  const auto value = node ? node->value_exact<std::int64_t>() : std::nullopt;
  return value && *value >= lo && *value <= hi ? value : std::nullopt;
}

}  // namespace

std::string listNames(std::span<const std::string_view> names) {
  std::string list;
  for (const std::string_view name : names) list += (list.empty() ? "\"" : ", \"") + std::string(name) + '"';
  return list;
}

bool Flag::read(const Value& in, bool& out) const {
  const auto value = in.node.value_exact<bool>();
  if (!value) return in.mustBe("true or false");
  out = *value;
  return true;
}

bool Text::read(const Value& in, std::string& out) const {
  const auto value = in.string();
  // Names end up in tables, on terminals and as layers of images: nothing there that is not printable.
  if (!value || value->empty() || printable(*value, kMaxLength) != *value) {
    return in.mustBe(std::string("a string of 1 to ").append(std::to_string(kMaxLength)) +
                     " characters, none of them a control character");
  }
  out = *value;
  return true;
}

std::string numberText(const Range& range, std::string_view unit) {
  return "a number " + range.text() + (unit.empty() ? "" : " " + std::string(unit));
}

bool Number::read(const Value& in, double& out) const {
  const auto value = in.numberIn(range);
  if (!value) return in.mustBe(numberText(range, unit));
  out = *value;
  return true;
}

bool WholeNumber::read(const Value& in, int& out) const {
  const auto value = integerIn(&in.node, least, most);
  if (!value) return in.mustBe("a whole number from " + std::to_string(least) + " to " + std::to_string(most));
  out = static_cast<int>(*value);
  return true;
}

bool Angle::read(const Value& in, double& out) const {
  const auto value = in.numberIn(degreesRange);
  if (!value) return in.mustBe(numberText(degreesRange, "degrees"));
  out = radians(*value);
  return true;
}

bool Seed::read(const Value& in, std::uint64_t& out) const {
  const auto value = integerIn(&in.node, 0, INT64_MAX);
  if (!value) return in.mustBe("an integer, at least 0");
  out = static_cast<std::uint64_t>(*value);
  return true;
}

bool Date::read(const Value& in, DateTime& out) const {
  constexpr const char* kForm = "a date and time with its offset from UTC, such as 2026-12-21T09:30:00+01:00";
  const toml::value<toml::date_time>* given = in.node.as_date_time();
  if (!given)
    return in.mustBe(kForm, beginsAsDate(in.string().value_or(""))
                                ? "does that date exist, has it seconds, and is it without quotes?"
                                : "");
  const auto& [date, time, offset] = given->get();
  if (!offset)
    return in.reject(std::string("'").append(in.key) + "' says no offset from UTC: it must be " + kForm,
                     "Z in the place of +01:00 is UTC");
  if (date.year < kFirstYear || date.year > kLastYear)
    return in.reject(std::string("'").append(in.key) + "' must be in a year from " + std::to_string(kFirstYear) +
                     " to " + std::to_string(kLastYear) + ", not " + std::to_string(date.year));
  out = {date.year,      date.month, date.day, time.hour, time.minute, time.second + 1e-9 * time.nanosecond,
         offset->minutes};
  return true;
}

bool RayCount::read(const Value& in, std::uint64_t& out) const {
  const auto number = in.node.value<double>();
  try {
    out = parseRayCount(in.isNumber() && number ? formatNumber(*number) : in.string().value_or(""));
    return true;
  } catch (const std::invalid_argument& e) {
    return in.mustBe(e.what());
  }
}

Json RayCount::schema() const {
  const Json number = {{"type", "number"}, {"minimum", 1}, {"maximum", kMaxRays}, {"multipleOf", 1}};
  const Json text = {{"type", "string"}, {"pattern", "^[0-9]+(\\.[0-9]*)?([eE]\\+?[0-9]+|[kKmMgGtT])?$"}};
  return {{"anyOf", {number, text}}};
}

bool Resolution::read(const Value& in, std::array<int, 2>& out) const {
  const toml::array* list = in.node.as_array();
  const bool isPair = list && list->size() == 2;
  const auto width = integerIn(isPair ? list->get(0) : nullptr, 1, kMaxImageSide);
  const auto height = integerIn(isPair ? list->get(1) : nullptr, 1, kMaxImageSide);
  if (!width || !height) {
    return in.reject(
        std::string("'resolution' must be [width, height], integers from 1 to ").append(std::to_string(kMaxImageSide)) +
        " pixels");
  }
  if (*width * *height > kMaxImagePixels) {
    return in.reject(std::string("an image of ").append(std::to_string(*width * *height)) +
                     " pixels is too large; at most " + std::to_string(kMaxImagePixels));
  }
  out = {static_cast<int>(*width), static_cast<int>(*height)};
  return true;
}

Json Resolution::schema() const {
  const Json side = {{"type", "integer"}, {"minimum", 1}, {"maximum", kMaxImageSide}};
  return {{"type", "array"}, {"items", side}, {"minItems", 2}, {"maxItems", 2}};
}

}  // namespace parhelion::kinds
