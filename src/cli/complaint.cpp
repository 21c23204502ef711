// SPDX-License-Identifier: Apache-2.0
#include "cli/complaint.h"

#include <algorithm>
#include <string_view>
#include <vector>

#include "cli/say.h"
#include "scene/suggest.h"

namespace parhelion::cli {

namespace {

std::string withHint(const std::string& text, const std::string& hint) {
  return hint.empty() ? text : text + "; " + hint;
}

/// All names of a command's options, with their dashes.
std::vector<std::string> optionsOf(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
  }
  return names;
}

/// The names of the commands that have an option.
std::string ownersOf(const CLI::App& app, const std::string& option) {
  std::string owners;
  for (const CLI::App* command : app.get_subcommands({})) {
    const std::vector<std::string> names = optionsOf(*command);
    if (std::find(names.begin(), names.end(), option) == names.end()) continue;
    owners += (owners.empty() ? "" : ", ") + command->get_name();
  }
  return owners;
}

std::string ofOption(const CLI::App& app, const CLI::App& command, const std::string& said) {
  const std::string option = said.substr(0, said.find('='));
  const std::string text = "unknown option " + inQuotes(option) + (&command == &app ? "" : " of " + command.get_name());
  const std::string owners = ownersOf(app, option);
  const std::vector<std::string> names = optionsOf(command);
  if (option == "-o" && std::ranges::find(names, "--csv") != names.end())
    return withHint(text, "results go to --csv, --json or --map");
  const std::string near = didYouMean(option, std::vector<std::string_view>(names.begin(), names.end()));
  return withHint(text, !near.empty() || owners.empty() ? near : "it belongs to " + owners);
}

std::string ofCommand(const CLI::App& app, const std::string& said) {
  std::vector<std::string_view> commands;
  const auto all = app.get_subcommands({});
  for (const CLI::App* command : all) commands.push_back(command->get_name());
  return withHint("unknown command " + inQuotes(said), didYouMean(said, commands));
}

/// Of the words that nobody has asked for.
std::string ofExtras(const CLI::App& app) {
  const auto chosen = app.get_subcommands();
  const CLI::App& command = chosen.empty() ? app : *chosen.front();
  std::vector<std::string> words = command.remaining();
  if (words.empty()) return {};
  // CLI11 keeps the words of a subcommand from the last to the first.
  if (!chosen.empty()) std::reverse(words.begin(), words.end());
  const auto option = std::find_if(words.begin(), words.end(),
                                   [](const std::string& word) { return word.size() > 1 && word.starts_with('-'); });
  if (option != words.end()) return ofOption(app, command, *option);
  if (chosen.empty()) return ofCommand(app, words.front());
  return command.get_name() + " does not expect " + inQuotes(words.front());
}

}  // namespace

std::string complaint(const CLI::App* app, const CLI::Error& error) {
  // CLI11 complains of what is missing first: "A subcommand is required" where one is misspelt.
  const bool ofWords = dynamic_cast<const CLI::RequiredError*>(&error) || dynamic_cast<const CLI::ExtrasError*>(&error);
  const std::string extras = ofWords ? ofExtras(*app) : "";
  return extras.empty() ? error.what() : extras;
}

}  // namespace parhelion::cli
