// SPDX-License-Identifier: Apache-2.0
// Runs that get fewer threads or less memory than they would like.
#include <doctest/doctest.h>

#include <string>

#include <unistd.h>

#include <nlohmann/json.hpp>

#include "rendered_sky.h"

using namespace parhelion::test;

namespace {

/// The program with at most so many threads, its first one included. The limit does not hold for root: then it belongs
/// to a user who has no other processes.
std::string withThreads(int most, const std::string& arguments) {
  const std::string user = ::geteuid() == 0 ? "setpriv --reuid 61234 --clear-groups " : "";
  return "prlimit --core=0 --nproc=" + std::to_string(most) + " " + user + "'" PARHELION_BINARY "' " + arguments;
}

double peakMemory(const Folder& folder) {
  return nlohmann::json::parse(readFile(folder / "s.json")).at("peak_memory_bytes").get<double>();
}

/// Scene of so many populations, no two alike.
std::string manyPopulations(int count) {
  std::string scene = "[camera]\nresolution = [32, 32]\n[trace]\nrays = 20_000\n";
  for (int i = 0; i < count; ++i)
    scene += "[[population]]\norientation = \"plate\"\naspect = " + std::to_string(0.1 + 1e-4 * i) + "\n";
  return scene;
}

}  // namespace

#ifndef __SANITIZE_ADDRESS__  // which takes threads and memory of its own
TEST_CASE("with fewer threads than wanted a run says so and traces the same bytes") {
  const Folder folder;
  std::filesystem::permissions(folder.path(), std::filesystem::perms::all);
  writeFile(folder / "s.toml", kScene);
  REQUIRE(run(folder, "parhelion trace s.toml --quiet -o whole.exr").exit == 0);
  for (const int most : {1, 2, 3, 5}) {
    const Outcome outcome = run(folder, withThreads(most, "trace s.toml --nthreads 8 --quiet --overwrite -o t.exr"));
    CAPTURE(most);
    CAPTURE(outcome.err);
    CHECK(outcome.exit == 0);
    CHECK(outcome.err.find("fewer start than wanted (ulimit -u") != std::string::npos);
    CHECK(lines(outcome.err) == 1);
    CHECK(readFile(folder / "t.exr") == readFile(folder / "whole.exr"));
  }
  // What has threads of its own: reconstruction, and the search for the sky.
  for (const char* command :
       {"render s.toml --nthreads 8 --quiet -o r.exr", "recon whole.exr --nthreads 8 --quiet -o r.exr",
        "view r.exr --overlay --unsharp 3,5 --quiet -o v.png"}) {
    const Outcome outcome = run(folder, withThreads(2, command));
    CHECK_MESSAGE(outcome.exit == 0, command << " said " << outcome.err);
  }
}

TEST_CASE("an overlay for which there is too little memory is one line, however much is missing") {
  const WithSky folder;
  int drawn = 0, refused = 0;
  for (int megabytes = 60; megabytes <= 260; megabytes += 4) {
    const Outcome outcome = run(folder, "(ulimit -c 0; ulimit -v " + std::to_string(1024 * megabytes) +
                                            "; '" PARHELION_BINARY "' view s.exr --overlay --quiet -o v.png)");
    if (outcome.err.find("error while loading shared libraries") != std::string::npos) continue;
    CAPTURE(megabytes);
    CAPTURE(outcome.err);
    CHECK((outcome.exit == 0 || outcome.exit == 1));
    CHECK(lines(outcome.err) == outcome.exit);
    ++(outcome.exit == 0 ? drawn : refused);
  }
  CHECK(drawn > 0);
  CHECK(refused > 0);
}

TEST_CASE("five thousand populations take less than 300 MB") {
  const Folder folder;
  writeFile(folder / "s.toml", manyPopulations(5000));
  const Outcome outcome = run(folder, "parhelion render s.toml --nthreads 2 --quiet -o o.exr --stats s.json");
  REQUIRE_MESSAGE(outcome.exit == 0, outcome.err);
  MESSAGE("peak memory, bytes: " << peakMemory(folder));
  CHECK(peakMemory(folder) < 300e6);
}
#endif
