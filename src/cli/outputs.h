// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace parhelion::cli {

/// Adds --overwrite to a subcommand that writes files.
void addOverwrite(CLI::App& command, bool& overwrite);

/// What a command reads and what it is about to write. Empty names do not count, "-" is stdin and stdout.
struct Files {
  std::vector<std::string> inputs, outputs;
};

/// For commands, before they work: throws CLI::ValidationError if two of the outputs are one file or one of them is an
/// input, and std::runtime_error if one cannot be written or, unless `overwrite`, would replace a file that parhelion
/// has not written (isOwnFile). Pipes and devices have nothing to lose. Changes nothing.
void requireOutputs(const Files& files, bool overwrite);

/// Whether this is the name of something open, a pipe or a device, or "-".
bool isStream(const std::string& name);

/// Whether it is that of the device that throws everything away, /dev/null.
bool isNull(const std::string& name);

}  // namespace parhelion::cli
