// SPDX-License-Identifier: Apache-2.0
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <new>
#include <string>

#if defined(__SSE2__)
#include <pmmintrin.h>
#include <xmmintrin.h>
#endif

#include "cli/commands.h"
#include "cli/complaint.h"
#include "cli/process.h"
#include "cli/say.h"
#include "scene/scene_error.h"

namespace {

/// Embree asks for denormals to be flushed to zero; threads started later inherit the setting.
void flushDenormals() {
#if defined(__SSE2__)
  _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
  _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
#endif
}

int run(int argc, char** argv) {
  using namespace parhelion::cli;
  CLI::App app("Parhelion renders the halos that ice crystals draw around the sun.", "parhelion");
  app.set_version_flag("--version", "parhelion " PARHELION_VERSION);
  app.require_subcommand(1);

  int exit = kDone;
  addCommands(app, exit);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // the help
    say("parhelion: error: %s", complaint(&app, error).c_str());
    say("(--help lists what there is)");
    return kUsageError;
  }
  return exit;
}

int fail(const std::string& reason) {
  parhelion::cli::say("parhelion: error: %s", reason.c_str());
  return parhelion::cli::kRunTimeFailure;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace parhelion::cli;
  prepareProcess();
  flushDenormals();
  try {
    const int code = run(argc, argv);
    if (std::fflush(stdout) != 0 || std::ferror(stdout)) return fail(std::string("stdout: ") + std::strerror(errno));
    return code;
  } catch (const parhelion::SceneError& error) {
    sayLines(std::string(error.what()) + "\n");
    return kUsageError;
  } catch (const std::bad_alloc&) {
    return fail("out of memory");
  } catch (const std::exception& error) {
    return fail(error.what());
  }
}
