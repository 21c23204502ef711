// SPDX-License-Identifier: Apache-2.0
// What signals do to a run.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "long_runs.h"

using namespace parhelion::test;
using nlohmann::json;

namespace {

// Rays enough to last until somebody stops it.
const std::string kEndless = " --rays 20G --checkpoint 0.05s ";

}  // namespace

TEST_CASE("TERM, INT and XCPU save what was traced, and the run goes on from there to the same bytes") {
  const LongRuns folder;
  for (const char* signal : {"TERM", "INT", "XCPU"}) {
    const std::string name = std::string(signal) + ".exr";
    const Outcome stopped = run(
        folder, inBackground("trace mirror.toml -o " + name + kEndless, until(name) + "; kill -" + signal + " $pid"));
    CHECK_MESSAGE(stopped.exit == 75, signal << ": " << stopped.err);
    CHECK(stopped.err.find("interrupted") != std::string::npos);
    REQUIRE(run(folder, "parhelion trace mirror.toml --quiet --rays 20G --time 0.2 --resume " + name).exit == 0);
    CHECK(run(folder, "parhelion info " + name).exit == 0);
  }
}

TEST_CASE("HUP leaves the checkpoint of a render and no picture, TERM both") {
  const LongRuns folder;
  const Outcome hup = run(folder, inBackground("render mirror.toml -o a.exr --quiet" + kEndless,
                                               until("a.tally.exr") + "; kill -HUP $pid"));
  CHECK_MESSAGE(hup.exit == 75, hup.err);
  CHECK(std::filesystem::exists(folder / "a.tally.exr"));
  CHECK_FALSE(std::filesystem::exists(folder / "a.exr"));
  const Outcome term = run(folder, inBackground("render mirror.toml -o b.exr --quiet" + kEndless,
                                                until("b.tally.exr") + "; kill -TERM $pid"));
  CHECK_MESSAGE(term.exit == 75, term.err);
  CHECK(std::filesystem::exists(folder / "b.exr"));
  CHECK(run(folder, "parhelion recon b.tally.exr --quiet -o c.exr").exit == 0);
  // Also where nobody has thought of checkpoints: what was traced can be gone on from.
  const Outcome plain =
      run(folder, inBackground("render mirror.toml -o d.exr --rays 20G", kUntilReady + "; kill -TERM $pid"));
  CHECK(plain.exit == 75);
  CHECK(std::filesystem::exists(folder / "d.tally.exr"));
  const Outcome none = run(folder, inBackground("render mirror.toml -o e.exr --rays 20G --checkpoint none",
                                                kUntilReady + "; kill -HUP $pid"));
  CHECK(none.exit == 75);
  CHECK(std::filesystem::exists(folder / "e.exr"));
  CHECK_FALSE(std::filesystem::exists(folder / "e.tally.exr"));
}

TEST_CASE("nohup keeps a run from HUP, and USR1 writes a checkpoint of a run that goes on") {
  const LongRuns folder;
  const Outcome outcome = run(folder, "{ nohup '" PARHELION_BINARY
                                      "' trace plain.toml -o t.exr --rays 20G --checkpoint 1h 2> err & pid=$!; " +
                                          kUntilReady + "; kill -HUP $pid; kill -USR1 $pid; " + until("t.exr") +
                                          "; kill -0 $pid || exit 9; cp t.exr c.exr; kill -TERM $pid; wait $pid; }");
  CHECK_MESSAGE(outcome.exit == 75, outcome.err);
  CHECK(readFile(folder / "err").find("checkpoint: ") != std::string::npos);
  CHECK(run(folder, "parhelion recon c.exr --quiet -o /dev/null").exit == 0);
}

#ifndef __SANITIZE_THREAD__  // which keeps signals back for a while, and hands on the later one first
TEST_CASE("a second signal ends the program at once") {
  const LongRuns folder;
  // Between the two signals the large picture is being made, which takes much longer than a moment.
  for (const std::string first : {"TERM", "INT"})
    for (const std::string second : {"TERM", "INT"}) {
      const Outcome outcome = run(
          folder,
          inBackground("render plain.toml --resolution 3000x3000 --checkpoint none -o big.exr --rays 20G",
                       kUntilReady + "; kill -" + first + " $pid; sleep 0.3; kill -" + second + " $pid 2>/dev/null"));
      CAPTURE(first);
      CAPTURE(second);
      CHECK(outcome.exit == (second == "TERM" ? 143 : 130));
      CHECK_FALSE(std::filesystem::exists(folder / "big.exr"));
      for (const std::string& name : folder.names()) CHECK_MESSAGE(!name.ends_with(".tmp"), name);
    }
}

TEST_CASE("all that a run says on its way is JSON where its progress is") {
  const LongRuns folder;
  REQUIRE(run(folder,
              "parhelion trace plain.toml --quiet --rays 2000 -o t.exr.previous -D trace.rays=20G --ray-range "
              "0:2000")
              .exit == 0);
  const Outcome outcome = run(folder, inBackground("trace plain.toml --resume t.exr --rays 20G --checkpoint 0.05s "
                                                   "--progress json",
                                                   until("t.exr") + "; kill -TERM $pid"));
  CHECK(outcome.exit == 75);
  std::istringstream words(outcome.err);
  int checkpoints = 0, remarks = 0;
  for (std::string line; std::getline(words, line) && line.starts_with("{");) {
    const json event = json::parse(line);
    remarks += event.contains("remark") ? 1 : 0;
    if (!event.contains("checkpoint")) continue;
    ++checkpoints;
    CHECK(event["checkpoint"] == "t.exr");
    CHECK(event["rays"].get<std::uint64_t>() > 2000);
  }
  CHECK(checkpoints > 0);
  CHECK(remarks > 1);
  CHECK(outcome.err.find("\ncheckpoint:") == std::string::npos);
  CHECK(outcome.err.find("\n--resume") == std::string::npos);
}
#endif

TEST_CASE("a reader of the progress that goes does not end a run, and a table without a reader is one clear error") {
  const LongRuns folder;
  const Outcome outcome =
      run(folder,
          "{ parhelion trace plain.toml --rays 2M -o t.exr --progress json; echo $? > code; } 2>&1 | "
          "head -1; while ! [ -s code ]; do sleep 0.01; done");
  CHECK(readFile(folder / "code") == "0\n");
  CHECK(run(folder, "parhelion info t.exr").exit == 0);
  run(folder,
      "{ parhelion profile plain.toml --rays 2k --bins 100000 --quiet 2> err; echo $? > code; } | true; "
      "while ! [ -s code ]; do sleep 0.01; done");
  CHECK(readFile(folder / "code") == "1\n");
  CHECK(readFile(folder / "err").find("stdout") != std::string::npos);
}

TEST_CASE("a checkpoint that cannot be written is one warning, and the run goes on") {
  const LongRuns folder;
  // The picture is small, the rings of its tally are not: files of 30 kB can be written, larger ones cannot.
  const Outcome outcome =
      run(folder, "(ulimit -f 60; trap '' XFSZ; '" PARHELION_BINARY
                  "' render radial.toml --resolution 32x32 --rays 1M -o p.exr --checkpoint 0.01s --progress json)");
  CHECK_MESSAGE(outcome.exit == 1, outcome.err);
  CHECK(outcome.err.find("{\"warning\":\"no checkpoint: ") != std::string::npos);
  CHECK(outcome.err.find("warning") == outcome.err.rfind("warning"));
  CHECK_FALSE(std::filesystem::exists(folder / "p.tally.exr"));
}
