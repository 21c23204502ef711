// SPDX-License-Identifier: Apache-2.0
#pragma once

// All that the command line offers, as its definition has it, so that no option is forgotten.

#include <set>
#include <string>
#include <vector>

#include "cli/commands.h"

namespace parhelion::test {

/// An option or a word of a command that takes a text.
struct Asked {
  std::string command;
  std::string option;  // "--step", "-D"; empty for a word by itself, such as the scene

  /// How a text is given to it.
  std::vector<std::string> with(const std::string& text) const {
    if (option.empty()) return {command, text};
    if (option.starts_with("--")) return {command, option + "=" + text};
    return {command, option, text};
  }
};

/// The program's command line without what its commands do.
class CommandLine {
 public:
  CommandLine() {
    cli::addCommands(app_, exit_, tracers_);
    app_.require_subcommand(2);  // which nobody gives: so no command ever starts
  }

  std::vector<Asked> asked() {
    std::vector<Asked> all;
    for (const CLI::App* command : app_.get_subcommands({}))
      for (const CLI::Option* option : command->get_options())
        if (option->get_items_expected_max() > 0)
          all.push_back({command->get_name(), option->get_positional() ? "" : option->get_name()});
    return all;
  }

  std::vector<std::string> commands() {
    std::vector<std::string> all;
    for (const CLI::App* command : app_.get_subcommands({})) all.push_back(command->get_name());
    return all;
  }

  /// What it says against a text for an option; empty if nothing. What else the command lacks does not count.
  std::string complaintOf(const Asked& asked, const std::string& text) {
    std::vector<std::string> words = asked.with(text);
    std::vector<std::string> backwards(words.rbegin(), words.rend());  // as CLI11 wants them
    try {
      app_.parse(backwards);
    } catch (const CLI::RequiredError&) {
    } catch (const CLI::RequiresError&) {
    } catch (const CLI::ParseError& error) {
      return error.what();
    }
    return {};
  }

 private:
  CLI::App app_;
  int exit_ = 0;
  Tracers tracers_;
};

/// Options that take any text: names of files and folders, keys of scenes. Their own readers judge them.
inline bool takesAnyText(const Asked& asked) {
  static const std::set<std::string> kNames{"",        "-o",        "--output", "--stats", "--scene",   "--halo",
                                            "--mask",  "--layers",  "--beside", "--minus", "--profile", "--summary",
                                            "-D",      "--compare", "--resume", "--tally", "--slice",   "--paths",
                                            "--layer", "--csv",     "--json"};
  return kNames.contains(asked.option);
}

}  // namespace parhelion::test
