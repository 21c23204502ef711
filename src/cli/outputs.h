// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "picture/transaction.h"

namespace parhelion::cli {

/// Adds --overwrite to a subcommand that writes files.
void addOverwrite(CLI::App& command, bool& overwrite);

/// What a command reads and what it is about to write. Empty names do not count, "-" is stdin and stdout. Folders are
/// those that the outputs need and that are made if they are not there.
struct Files {
  std::vector<std::string> inputs, outputs, folders = {};
  std::map<std::string, std::uint64_t> leastBytes = {};  // of outputs, where that is known
};

/// For commands, before they work: the outputs, claimed for this run. Throws CLI::ValidationError if two of them are
/// one file or one is an input. Throws std::runtime_error if one cannot be written, is being written by another run,
/// would not find room on its disk or, unless `overwrite`, would replace a file that parhelion has not written
/// (isOwnFile). Pipes and devices have nothing to lose. Leaves all files as they are.
Transaction claimOutputs(const Files& files, bool overwrite);

/// The same without keeping the claims, for commands with too many outputs. Makes no folders.
void requireOutputs(const Files& files, bool overwrite);

/// Whether this is the name of something open, a pipe or a device, or "-".
bool isStream(const std::string& name);

/// Whether it is that of the device that throws everything away, /dev/null.
bool isNull(const std::string& name);

}  // namespace parhelion::cli
