// SPDX-License-Identifier: Apache-2.0
// The words of a command line, a line each, and all that reads numbers in them. No command starts.
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "cli/commands.h"
#include "cli/complaint.h"
#include "cli/number_options.h"
#include "scene/key_range.h"
#include "scene/parse_scene.h"
#include "scene/utf8.h"

namespace {

template <class Read>
void mayRefuse(const Read& read) {
  try {
    read();
  } catch (const std::invalid_argument&) {
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace parhelion;
  const std::string text(reinterpret_cast<const char*>(data), size);
  std::vector<std::string> words;
  for (std::size_t at = 0; at <= text.size() && words.size() < 16;) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    words.insert(words.begin(), text.substr(at, end - at));  // CLI11 wants them backwards
    at = end + 1;
  }
  int exit = 0;
  CLI::App app("", "parhelion");
  Tracers tracers;
  cli::addCommands(app, exit, tracers);
  app.require_subcommand(1000);  // more than there are, so that none starts
  for (const std::string& word : words) {
    mayRefuse([&] { parseKeyRange(word); });
    mayRefuse([&] { parseRayCount(word); });
    cli::commaSeparated(word);
    escaped(word);
  }
  try {
    app.parse(words);
  } catch (const CLI::ParseError& error) {
    cli::complaint(&app, error);
  }
  return 0;
}
