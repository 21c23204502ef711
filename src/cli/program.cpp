// SPDX-License-Identifier: Apache-2.0
#include "cli/program.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <new>
#include <string>

#include "cli/commands.h"
#include "cli/complaint.h"
#include "cli/process.h"
#include "cli/say.h"
#include "cli/thread_words.h"
#include "scene/scene_error.h"

namespace parhelion::cli {

namespace {

int run(int argc, char** argv, Tracers& tracers) {
  CLI::App app("Parhelion renders the halos that ice crystals draw around the sun.", "parhelion");
  app.set_version_flag("--version", "parhelion " PARHELION_VERSION);
  app.require_subcommand(1);

  int exit = kDone;
  countThreads();
  addCommands(app, exit, tracers);
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

int fail(const std::string& reason, int code = kRunTimeFailure) {
  say("parhelion: error: %s", reason.c_str());
  return code;
}

}  // namespace

int runProgram(int argc, char** argv, Tracers& tracers) {
  prepareProcess();
  try {
    const int code = run(argc, argv, tracers);
    sayMissingThreads();
    if (std::fflush(stdout) != 0 || std::ferror(stdout)) return fail(std::string("stdout: ") + std::strerror(errno));
    return code;
  } catch (const SceneError& error) {
    sayLines(std::string(error.what()) + "\n");
    return kUsageError;
  } catch (const Unfit& error) {
    return fail(error.what(), kUsageError);
  } catch (const std::bad_alloc&) {
    return fail("out of memory");
  } catch (const std::exception& error) {
    return fail(error.what());
  }
}

}  // namespace parhelion::cli
