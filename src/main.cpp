// SPDX-License-Identifier: Apache-2.0
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <new>
#include <string>
#include <string_view>
#include <vector>

#if defined(__SSE2__)
#include <pmmintrin.h>
#include <xmmintrin.h>
#endif

#include "cli/commands.h"
#include "scene/scene_error.h"
#include "scene/suggest.h"

namespace {

/// Embree asks for denormals to be flushed to zero; threads started later inherit the setting.
void flushDenormals() {
#if defined(__SSE2__)
  _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
  _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
#endif
}

/// One line, with a suggestion where the first word is nearly a command.
std::string complaint(const CLI::App* app, const CLI::Error& error) {
  std::string text = "parhelion: error: " + std::string(error.what());
  const auto words = app->remaining();
  if (!words.empty()) {
    std::vector<std::string_view> commands;
    const auto subcommands = app->get_subcommands({});
    for (const CLI::App* command : subcommands) commands.push_back(command->get_name());
    text = "parhelion: error: unknown command '" + words.front() + "'";
    if (const std::string hint = parhelion::didYouMean(words.front(), commands); !hint.empty()) text += "; " + hint;
  }
  return text + "\n(--help lists what there is)\n";
}

int run(int argc, char** argv) {
  using namespace parhelion::cli;
  CLI::App app("Parhelion renders the halos that ice crystals draw around the sun.", "parhelion");
  app.set_version_flag("--version", "parhelion " PARHELION_VERSION);
  app.require_subcommand(1);
  app.failure_message(complaint);

  int exit = kDone;
  addRender(app, exit);
  addTrace(app, exit);
  addRecon(app, exit);
  addComposite(app, exit);
  addSweep(app, exit);
  addView(app, exit);
  addProfile(app, exit);
  addMap(app, exit);
  addReplay(app, exit);
  addInfo(app, exit);
  addCheck(app, exit);
  addSchema(app, exit);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kDone : kUsageError;
  }
  return exit;
}

int fail(const char* what, int code) {
  std::fprintf(stderr, "%s\n", what);
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace parhelion::cli;
  flushDenormals();
  try {
    const int code = run(argc, argv);
    if (std::fflush(stdout) != 0 || std::ferror(stdout))
      return fail((std::string("parhelion: error: stdout: ") + std::strerror(errno)).c_str(), kRunTimeFailure);
    return code;
  } catch (const parhelion::SceneError& error) {
    return fail(error.what(), kUsageError);
  } catch (const std::bad_alloc&) {
    return fail("parhelion: error: out of memory", kRunTimeFailure);
  } catch (const std::exception& error) {
    return fail((std::string("parhelion: error: ") + error.what()).c_str(), kRunTimeFailure);
  }
}
