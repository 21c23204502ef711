// SPDX-License-Identifier: Apache-2.0
#include "cli/memory_option.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "cli/number_options.h"
#include "math/number_text.h"
#include "picture/memory_limit.h"

namespace parhelion::cli {

namespace {

constexpr double kLeast = 1e6, kMost = 1e15;  // bytes; less could not even start

/// "500M", "2.5G" or "4000000000" in bytes; k, M, G and T are powers of 1000, and a B may follow.
std::optional<std::uint64_t> sizeIn(std::string_view text) {
  if (text.ends_with('B')) text.remove_suffix(1);
  double unit = 1.0;
  constexpr std::string_view kSuffixes = "kMGT";
  if (const std::size_t at = text.empty() ? std::string_view::npos : kSuffixes.find(text.back());
      at != std::string_view::npos) {
    for (std::size_t i = 0; i <= at; ++i) unit *= 1000.0;
    text.remove_suffix(1);
  }
  const std::optional<double> number = numberIn(text);
  if (!number || !(*number * unit >= kLeast && *number * unit <= kMost)) return std::nullopt;
  return static_cast<std::uint64_t>(*number * unit);
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
