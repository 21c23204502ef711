// SPDX-License-Identifier: Apache-2.0
#pragma once

// Numbers on the command line. All of them are read by math/number_text.h; CLI11 gets to see only what is one.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

namespace parhelion::cli {

// For an option's transform(): they complain, in one line that says what was expected, unless its text is a number
// within the bounds, and leave it in the form that CLI11 reads in one way only.
CLI::Validator number(double least, double most);
CLI::Validator wholeNumber(std::int64_t least, std::int64_t most);

/// From 0, as far as a scene file can hold it.
CLI::Validator wholeNumber();

/// "expected " and that, not the word that stands there.
std::string expectedNot(const std::string& expected, std::string_view word);

/// Numbers with these separators between them, in their order: "10,20=30" with ",=". Empty where the text is anything
/// else, or a number is larger than any option takes.
std::vector<double> numbersIn(std::string_view text, std::string_view separators);

/// Any number of numbers with commas between them; empty where the text is anything else.
std::vector<double> commaSeparated(std::string_view text);

}  // namespace parhelion::cli
