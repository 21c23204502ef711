// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace parhelion::cli {

/// What is wrong with a command line that the program cannot use, in one line, with a suggestion where a word is nearly
/// a command or an option.
std::string complaint(const CLI::App* app, const CLI::Error& error);

}  // namespace parhelion::cli
