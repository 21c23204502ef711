// SPDX-License-Identifier: Apache-2.0
#include "sky/attribute_text.h"

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "math/checksum.h"

namespace parhelion {
namespace {

/// The number that is all of a text.
template <typename Number>
std::optional<Number> numberIn(std::string_view digits) {
  Number number{};
  const char* const end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, number);
  return error == std::errc{} && stop == end ? std::optional(number) : std::nullopt;
}

}  // namespace

std::string textOfUnits(ExactSum::Units units) {
  // Digits one by one from the last: the language prints no integers of this size.
  const bool negative = units < 0;
  std::string digits;
  do {
    const int digit = static_cast<int>(units % 10);
    digits += static_cast<char>('0' + (negative ? -digit : digit));
    units /= 10;
  } while (units != 0);
  if (negative) digits += '-';
  std::reverse(digits.begin(), digits.end());
  return digits;
}

void AttributeReader::reject(std::string_view name, std::string_view should) const {
  constexpr std::size_t kMostShown = 40;
  const auto found = attributes_.find(std::string(name));
  std::string message = std::string("attribute parhelion:").append(name);
  if (found == attributes_.end()) {
    message += " is missing, and should be ";
  } else {
    const bool isLong = found->second.size() > kMostShown;
    message += " is '" + found->second.substr(0, kMostShown) + (isLong ? "...'" : "'") + ", and should be ";
  }
  throw std::invalid_argument(message.append(should));
}

const std::string& AttributeReader::text(std::string_view name) const {
  const auto found = attributes_.find(std::string(name));
  if (found == attributes_.end()) reject(name, "a text");
  return found->second;
}

std::uint64_t AttributeReader::whole(std::string_view name) const {
  constexpr std::string_view kShould = "a whole number from 0 to 2^64 - 1";
  const auto number = has(name) ? numberIn<std::uint64_t>(text(name)) : std::nullopt;
  if (!number) reject(name, kShould);
  return *number;
}

std::uint64_t AttributeReader::hash(std::string_view name) const {
  const auto hash = has(name) ? fromHex(text(name)) : std::nullopt;
  if (!hash) reject(name, "16 hexadecimal digits");
  return *hash;
}

ExactSum::Units AttributeReader::units(std::string_view name) const {
  constexpr std::string_view kShould = "a whole number of 128 bits";
  std::string_view digits = has(name) ? std::string_view(text(name)) : std::string_view();
  const bool negative = digits.starts_with('-');
  if (negative) digits.remove_prefix(1);
  if (digits.empty()) reject(name, kShould);
  ExactSum::Units units = 0;
  for (const char c : digits) {
    const int digit = negative ? '0' - c : c - '0';
    if (c < '0' || c > '9' || __builtin_mul_overflow(units, ExactSum::Units{10}, &units) ||
        __builtin_add_overflow(units, ExactSum::Units{digit}, &units))
      reject(name, kShould);
  }
  return units;
}

double AttributeReader::number(std::string_view name, double from, double to) const {
  const auto number = has(name) ? numberIn<double>(text(name)) : std::nullopt;
  if (!number || !(*number >= from && *number <= to))
    reject(name, "a number from " + textOfNumber(from) + " to " + textOfNumber(to));
  return *number;
}

}  // namespace parhelion
