// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <charconv>
#include <cstdint>
#include <string>
#include <string_view>

#include "math/exact_sum.h"
#include "picture/exr.h"

namespace parhelion {

/// A number in the shortest form that reads back exactly.
template <typename Number>
std::string textOfNumber(Number value) {
  std::array<char, 32> digits{};
  const auto result = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  return std::string(digits.data(), static_cast<std::size_t>(result.ptr - digits.data()));
}

/// The whole number of units of a 128-bit sum, decimal.
std::string textOfUnits(ExactSum::Units units);

/// Reads the attributes of a tally, by their names without "parhelion:". All functions throw std::invalid_argument with
/// the attribute, what was found in it and what it should be.
class AttributeReader {
 public:
  explicit AttributeReader(const ExrAttributes& attributes) : attributes_(attributes) {}

  bool has(std::string_view name) const { return attributes_.contains(std::string(name)); }
  const std::string& text(std::string_view name) const;
  std::uint64_t whole(std::string_view name) const;
  std::uint64_t hash(std::string_view name) const;  // 16 hexadecimal digits
  ExactSum::Units units(std::string_view name) const;

  /// A finite number in [from, to].
  double number(std::string_view name, double from, double to) const;

  /// Throws that an attribute is not what it should be.
  [[noreturn]] void reject(std::string_view name, std::string_view should) const;

 private:
  const ExrAttributes& attributes_;
};

}  // namespace parhelion
