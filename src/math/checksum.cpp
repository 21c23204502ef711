// SPDX-License-Identifier: Apache-2.0
#include "math/checksum.h"

#include <xxhash.h>

#include <array>
#include <charconv>
#include <new>

namespace parhelion {

void Checksum::Free::operator()(XXH3_state_s* state) const { XXH3_freeState(state); }

Checksum::Checksum() : state_(XXH3_createState()) {
  if (!state_) throw std::bad_alloc();
  XXH3_64bits_reset(state_.get());
}

void Checksum::add(const void* data, std::size_t bytes) { XXH3_64bits_update(state_.get(), data, bytes); }

std::uint64_t Checksum::value() const { return XXH3_64bits_digest(state_.get()); }

std::string hexOf(std::uint64_t checksum) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string digits(16, '0');
  for (std::size_t i = 0; i < digits.size(); ++i) digits[i] = kDigits[checksum >> (60 - 4 * i) & 15];
  return digits;
}

std::optional<std::uint64_t> fromHex(std::string_view digits) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
  if (digits.size() != 16 || error != std::errc{} || end != digits.data() + digits.size()) return {};
  return value;
}

}  // namespace parhelion
