// SPDX-License-Identifier: Apache-2.0
#include "math/number_text.h"

#include <charconv>
#include <cmath>

namespace parhelion {

namespace {

template <class Number>
std::optional<Number> parsed(std::string_view text) {
  if (text.starts_with('+')) {
    text.remove_prefix(1);
    if (text.starts_with('-')) return {};
  }
  Number value{};
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  return error == std::errc() && stop == end ? std::optional(value) : std::nullopt;
}

}  // namespace

std::optional<double> numberIn(std::string_view text) {
  const std::optional<double> value = parsed<double>(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<std::int64_t> wholeNumberIn(std::string_view text) { return parsed<std::int64_t>(text); }

}  // namespace parhelion
