// SPDX-License-Identifier: Apache-2.0
#pragma once

// The one way in which a text that somebody has typed becomes a number.

#include <cstdint>
#include <optional>
#include <string_view>

namespace parhelion {

/// A finite decimal number, for one -1, +0.5 or 2e6, whatever the language of the machine. None where the text is
/// anything else or goes on behind the number: not of hexadecimal digits, nan, inf, blanks, nor of what a double cannot
/// hold.
std::optional<double> numberIn(std::string_view text);

/// A whole number in decimal digits, with a sign or without; zeros before it do not make it octal.
std::optional<std::int64_t> wholeNumberIn(std::string_view text);

}  // namespace parhelion
