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
