// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "shell.h"

using namespace parhelion::test;

TEST_CASE("every script tells what it does, refuses what it does not know, and does nothing then") {
  Folder folder;
  // A copy, so that nothing but the scripts is there to be found or changed.
  std::filesystem::copy(PARHELION_SOURCE_DIR "/scripts", folder / "scripts");
  for (const auto& entry : std::filesystem::directory_iterator(folder / "scripts")) {
    const std::string script = "scripts/" + entry.path().filename().string();
    for (const char* option : {" --help", " -h"}) {
      const Outcome help = run(folder, script + option);
      CHECK_MESSAGE(help.exit == 0, script);
      CHECK_MESSAGE(help.out.size() > 60, script);
      CHECK_MESSAGE(help.out.find("set -eu") == std::string::npos, help.out);
      CHECK_MESSAGE(help.out.find("SPDX") == std::string::npos, help.out);
    }
    // Arguments of the demonstration are those of render, which refuses them.
    if (script == "scripts/demo") continue;
    for (const char* unknown : {" --bogus", " --bogus 3", " 'no such thing'"}) {
      const Outcome refused = run(folder, script + unknown);
      CHECK_MESSAGE(refused.exit == 2, script << unknown << " said " << refused.err);
      CHECK_MESSAGE(lines(refused.err) == 1, refused.err);
    }
  }
  // A target that is there, so that it is what follows that is refused.
  std::filesystem::create_directories(folder / "tests/fuzz/corpus/png");
  for (const char* extra : {"fuzz 5 6", "fuzz jpeg", "fuzz png x", "fuzz png 5x", "fuzz all 5 6x", "fuzz png 5 6 7",
                            "figures a b c", "bench --quick rays more", "test ring", "test --bogus-regex x",
                            "sanitize ring", "sanitize thread ring", "sanitize thread --bogus-regex x"})
    CHECK_MESSAGE(run(folder, std::string("scripts/") + extra).exit == 2, extra);
  for (const char* name : {"out", "build", "--help", "--bogus", "docs"})
    CHECK_FALSE(std::filesystem::exists(folder / name));
}
