// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

namespace parhelion::cli {

/// Numbers with these separators between them, in their order: "10,20=30" with ",=". Empty where the text is anything
/// else, or a number is larger than any option takes.
std::vector<double> numbersIn(std::string_view text, std::string_view separators);

/// Any number of numbers with commas between them; empty where the text is anything else.
std::vector<double> commaSeparated(std::string_view text);

}  // namespace parhelion::cli
