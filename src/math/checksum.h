// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

struct XXH3_state_s;  // of the library

namespace parhelion {

/// XXH3 with 64 bits and seed 0 of bytes that come piece by piece. It finds damage, not forgery.
class Checksum {
 public:
  Checksum();

  void add(const void* data, std::size_t bytes);
  void add(std::string_view text) { add(text.data(), text.size()); }

  /// Of all that has been added so far.
  std::uint64_t value() const;

 private:
  struct Free {
    void operator()(XXH3_state_s* state) const;
  };
  std::unique_ptr<XXH3_state_s, Free> state_;
};

/// 16 hexadecimal digits, as checksums and hashes stand in files.
std::string hexOf(std::uint64_t checksum);

/// The number of exactly such digits.
std::optional<std::uint64_t> fromHex(std::string_view digits);

}  // namespace parhelion
