// SPDX-License-Identifier: Apache-2.0
// The words of a command line, a line each, and all that reads numbers in them. No command starts, but what commands
// make of their options is made.
#include <string>
#include <string_view>
#include <vector>

#include "cli/commands.h"
#include "cli/complaint.h"
#include "cli/duration.h"
#include "cli/long_run_options.h"
#include "cli/memory_option.h"
#include "cli/number_options.h"
#include "cli/photo_options.h"
#include "cli/picture.h"
#include "cli/say.h"
#include "cli/view_options.h"
#include "input_file.h"
#include "math/duration_text.h"
#include "scene/key_range.h"
#include "scene/utf8.h"

namespace {

using namespace parhelion;
using Words = std::vector<std::string>;

Words linesOf(std::string_view text) {
  constexpr std::size_t kMostWords = 24;
  Words words;
  while (words.size() < kMostWords) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    words.emplace_back(text.substr(0, end));
    if (end == text.size()) break;
    text.remove_prefix(end + 1);
  }
  return words;
}

/// Calls what may complain about options.
template <class Use>
void mayComplain(const Use& use) {
  try {
    use();
  } catch (const CLI::ParseError&) {
  } catch (const SceneError&) {
  }
}

/// A program's command line. It takes longer to make than to use.
struct Program {
  CLI::App app{"", "parhelion"};
  Tracers tracers;
  int exit = 0;

  Program() {
    cli::addCommands(app, exit, tracers);
    app.require_subcommand(1000);  // more than there are, so that none starts
  }
};

/// The words for a whole program, which says what is wrong with them.
void parseAll(Words words) {
  static Program program;
  std::reverse(words.begin(), words.end());  // as CLI11 wants them
  try {
    program.app.parse(words);
  } catch (const CLI::ParseError& error) {
    cli::complaint(&program.app, error);
  }
}

/// The words that a group of options knows, and what is made of them.
template <class Options, class AddTo, class Use>
void parseInto(Words words, const AddTo& addTo, const Use& use) {
  struct Group {
    Options options;
    CLI::App app;

    explicit Group(const AddTo& add) {
      app.allow_extras();
      add(app, options);
    }
  };
  static Group group(addTo);
  group.options = Options();
  std::reverse(words.begin(), words.end());
  mayComplain([&] {
    group.app.parse(words);
    use(group.options);
  });
}

/// A scene in a file, for commands that need one.
const std::filesystem::path& sceneFile() {
  static const MemoryFile file;
  static const std::string scene = "[sun]\nelevation = 20.0\n[[population]]\nshape = \"prism\"\naspect = 1.0\n";
  return file.with(scene.data(), scene.size());
}

struct Run {
  cli::RunOptions run;
  cli::LongRunOptions longRun;
};

void useRun(Run& options) {
  options.run.scene = sceneFile().string();
  const LoadedScene loaded = options.run.load();
  constexpr int kBundle = 8;
  const RayRange range = options.longRun.wanted(loaded.scene.trace.rays, kBundle, options.run);
  require(range.count <= loaded.scene.trace.rays || options.longRun.isPart());
  options.longRun.interval();
  const double goal = options.longRun.goal();
  require(goal >= 0.0 && goal < 1.0);
  options.longRun.tallyFile();
}

Photograph somePhotograph() {
  Photograph photograph;
  photograph.width = 64;
  photograph.height = 48;
  return photograph;
}

void useView(cli::ViewOptions& options) {
  mayComplain([&] { options.photo.camera(somePhotograph(), "photograph", {}); });
  mayComplain([&] { options.requireSense(); });
  options.overlaySettings();
  options.profileSettings();
  if (!options.crystals.empty()) options.families();
  if (!options.unsharp.empty()) options.unsharpSettings();
}

/// A word where a number of some kind is expected.
void readNumber(const std::string& word) {
  cli::commaSeparated(word);
  if (const auto seconds = secondsIn(word)) cli::durationText(*seconds);
  // The validators of options change the words that they accept.
  for (const CLI::Validator& kind : {cli::number(-1e9, 1e9), cli::wholeNumber(), cli::durationInSeconds(0.0, 1e9)}) {
    std::string text = word;
    kind(text);
  }
  for (const auto& read :
       {+[](const std::string& text) { parseKeyRange(text); }, +[](const std::string& text) { parseRayCount(text); }}) {
    try {
      read(word);
    } catch (const std::invalid_argument&) {
    }
  }
}

/// The word behind each option that reads numbers in a way of its own.
void tryOptions(const std::string& word) {
  for (const char* name : {"--memory=", "--slice=", "--ray-range=", "--checkpoint=", "--error="}) {
    parseInto<cli::LongRunOptions>(
        {name + word},
        [](CLI::App& app, cli::LongRunOptions& all) {
          all.addTo(app, cli::LongRunOptions::Keeps::tallyBeside);
          cli::addMemory(app);
        },
        [](const cli::LongRunOptions& all) { mayComplain([&] { all.wanted(1000, 1, {}); }); });
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const Limits limits;
  const Words words = linesOf({reinterpret_cast<const char*>(data), size});
  for (const std::string& word : words) {
    readNumber(word);
    escaped(word);
    cli::inQuotes(word);
  }
  tryOptions(words.back());
  parseAll(words);
  parseInto<Run>(
      words,
      [](CLI::App& app, Run& all) {
        all.run.addTracingTo(app, true);
        all.longRun.addTo(app, cli::LongRunOptions::Keeps::tallyBeside);
      },
      useRun);
  parseInto<cli::ViewOptions>(
      words, [](CLI::App& app, cli::ViewOptions& all) { all.addTo(app); }, useView);
  parseInto<cli::PictureOptions>(
      words, [](CLI::App& app, cli::PictureOptions& all) { all.addTo(app); },
      [](cli::PictureOptions& all) { all.files("scene.toml"); });
  return 0;
}
