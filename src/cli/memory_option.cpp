// SPDX-License-Identifier: Apache-2.0
#include "cli/memory_option.h"

#include <cstdint>
#include <optional>
#include <string>

#include "cli/number_options.h"
#include "picture/memory_limit.h"

namespace parhelion::cli {

namespace {

constexpr std::uint64_t kLeast = 1'000'000;  // bytes; less could not even start

std::optional<std::uint64_t> sizeIn(const std::string& text) {
  const std::optional<std::uint64_t> bytes = bytesIn(text);
  return bytes && *bytes >= kLeast ? bytes : std::nullopt;
}

std::string validSize(const std::string& text) {
  return sizeIn(text) ? "" : expectedNot("a size of memory from 1M to 1000T, for one 500M or 4G", text);
}

}  // namespace

void addMemory(CLI::App& command) {
  command
      .add_option_function<std::string>(
          "--memory", [](const std::string& text) { setMemoryLimit(*sizeIn(text)); },
          "Memory to take at most; as there is, and for a file as its size lets expect, when left out")
      ->type_name("SIZE")
      ->check(CLI::Validator(validSize, ""));
}

}  // namespace parhelion::cli
