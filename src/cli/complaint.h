// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace parhelion::cli {

/// What the program says of a command line that it cannot use: what was wrong in one line, with a suggestion where a
/// word is nearly a command or an option, and where to look.
std::string complaint(const CLI::App* app, const CLI::Error& error);

}  // namespace parhelion::cli
