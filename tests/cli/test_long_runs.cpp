// SPDX-License-Identifier: Apache-2.0
// Runs in parts, killed runs and runs that go on have the bytes of one run that nobody disturbed.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "long_runs.h"

using namespace parhelion::test;
using nlohmann::json;

namespace {

std::string trace(const std::string& scene, const std::string& rest) {
  return "parhelion trace " + scene + ".toml --quiet " + rest;
}

}  // namespace

TEST_CASE("a run that is killed again and again and resumed has the bytes of an unbroken one") {
  const LongRuns folder;
  int kills = 0;
  for (const std::string& scene : LongRuns::kScenes) {
    REQUIRE(run(folder, trace(scene, "--rays 400001 -o whole.exr")).exit == 0);
    for (int i = 0; i < 40; ++i) {
      // Killed at other places and with another number of threads each time.
      const std::string seconds = "0." + std::to_string(10 + (i * 7) % 23);
      const Outcome outcome = run(folder, "timeout --foreground -s KILL " + seconds + " '" PARHELION_BINARY "' trace " +
                                              scene + ".toml --quiet --rays 400001 --resume " + scene +
                                              ".exr --checkpoint 0.01s --nthreads " + std::to_string(1 + i % 3));
      if (outcome.exit == 0 || outcome.exit == 124) break;  // 124: it was done by itself just as its time was over
      ++kills;
      REQUIRE_MESSAGE(outcome.exit == 137, outcome.err);
    }
    CHECK_MESSAGE(run(folder, trace(scene, "--rays 400001 --resume " + scene + ".exr")).exit == 0, scene);
    CHECK_MESSAGE(isSame(folder, scene + ".exr", "whole.exr"), scene);
  }
  MESSAGE("kills: " << kills);
  CHECK(kills > 0);
}

TEST_CASE("slices and ranges traced by themselves and one after the other hold all rays once") {
  const LongRuns folder;
  for (const std::string& scene : LongRuns::kScenes) {
    REQUIRE(run(folder, trace(scene, "--rays 30001 -o whole.exr")).exit == 0);
    // A later slice first, then the hole, which is traced into the same file.
    REQUIRE(run(folder, trace(scene, "--rays 30001 --slice 2/3 -o " + scene + ".exr")).exit == 0);
    const Outcome rest =
        run(folder, "parhelion trace " + scene + ".toml --rays 30001 --resume " + scene + ".exr --stats stats.json");
    REQUIRE(rest.exit == 0);
    CHECK(rest.err.find("rays 0 to 30000 are wanted, 20001 of them are missing") != std::string::npos);
    CHECK_MESSAGE(isSame(folder, scene + ".exr", "whole.exr"), scene);
    const json stats = json::parse(readFile(folder / "stats.json"));
    CHECK(stats["rays"] == 20'001);
    CHECK(stats["rays_held"] == 30'001);
    CHECK(stats["ray_ranges"] == json::parse("[[0, 30001]]"));
  }
  // The first of 64 slices has 468 rays, and a range may name them, too.
  REQUIRE(run(folder, trace("plain", "--rays 30001 --slice 1/64 -o slice.exr")).exit == 0);
  REQUIRE(run(folder, trace("plain", "--rays 30001 --ray-range 0:468 -o range.exr")).exit == 0);
  CHECK(isSame(folder, "slice.exr", "range.exr"));
}

TEST_CASE("a finished run goes on with more rays, also from within a bundle") {
  const LongRuns folder;
  for (const std::string& scene : LongRuns::kScenes) {
    REQUIRE(run(folder, trace(scene, "--rays 20002 -o whole.exr")).exit == 0);
    REQUIRE(run(folder, trace(scene, "--rays 10001 -o " + scene + ".exr")).exit == 0);
    REQUIRE(run(folder, trace(scene, "--rays 20002 --resume " + scene + ".exr -o more.exr")).exit == 0);
    CHECK_MESSAGE(isSame(folder, "more.exr", "whole.exr"), scene);
  }
  REQUIRE(run(folder, "parhelion render mirror.toml --quiet --rays 10001 --checkpoint 1h").exit == 0);
  REQUIRE(run(folder, "parhelion render mirror.toml --quiet --rays 20001 --resume mirror.tally.exr").exit == 0);
  REQUIRE(run(folder, "parhelion render mirror.toml --quiet --rays 20001 -o once.exr").exit == 0);
  CHECK(isSame(folder, "mirror.exr", "once.exr"));
  // Without a word about checkpoints a short run leaves none.
  CHECK_FALSE(std::filesystem::exists(folder / "once.tally.exr"));
}

TEST_CASE("a missing tally starts afresh, a damaged one goes on from the one before, each with a remark") {
  const LongRuns folder;
  const std::string command = "parhelion trace plain.toml --rays 20000 --resume t.exr";
  const Outcome fresh = run(folder, command);
  CHECK(fresh.exit == 0);
  CHECK(fresh.err.find("t.exr is not there") != std::string::npos);
  REQUIRE(run(folder,
              "mv t.exr whole.exr && parhelion trace plain.toml --quiet --rays 9000 -o t.exr.previous -D "
              "trace.rays=20000 --ray-range 0:9000")
              .exit == 0);
  for (const char* damage : {":", "head -c 2000 whole.exr > t.exr", ": > t.exr"}) {
    const Outcome before = run(folder, std::string(damage) + " && " + command);
    CHECK_MESSAGE(before.exit == 0, before.err);
    CHECK(before.err.find("t.exr.previous") != std::string::npos);
    CHECK(isSame(folder, "t.exr", "whole.exr"));
    std::filesystem::remove(folder / "t.exr");
  }
  // Where the one before is no better, nothing is lost by starting again without being told to.
  const Outcome bad = run(folder, "echo x > t.exr.previous; head -c 2000 whole.exr > t.exr; " + command);
  CHECK(bad.exit != 0);
  CHECK(std::filesystem::file_size(folder / "t.exr") == 2000);
}

TEST_CASE("a tally of another run is refused with the reason, and stays as it is") {
  const LongRuns folder;
  REQUIRE(run(folder, trace("plain", "--rays 1000 -o t.exr") + " && cp t.exr before.exr && parhelion render plain.toml "
                                                               "--rays 1000 --quiet -o picture.exr")
              .exit == 0);
  struct Case {
    const char *command, *says;
  };
  for (const auto& [command, says] :
       std::vector<Case>{{"trace plain.toml --seed 2 --resume t.exr", "seed"},
                         {"trace plain.toml -D population.0.aspect=0.4 --resume t.exr", "t.exr"},
                         {"trace plain.toml --resolution 32x32 --resume t.exr", "t.exr"},
                         {"trace mirror.toml --resume t.exr", "t.exr"},
                         {"trace plain.toml --resume picture.exr", "not a tally"},
                         {"trace mirror.toml --resume plain.toml", "not a tally"},
                         {"trace plain.toml --slice 4/3 -o o.exr", "--slice"},
                         {"trace plain.toml --slice 0/3 -o o.exr", "--slice"},
                         {"trace plain.toml --slice nan/3 -o o.exr", "--slice"},
                         {"trace plain.toml --ray-range 5:5 -o o.exr", "--ray-range"},
                         {"trace plain.toml --ray-range 1:5 -o o.exr", "0 or 2"},
                         {"trace plain.toml --rays 1k --ray-range 0:2k -o o.exr", "beyond"},
                         {"trace plain.toml --slice 1/2 --ray-range 0:2k -o o.exr", "--ray-range"},
                         {"trace plain.toml --slice 1/2 --error 1% -o o.exr", "--error"},
                         {"trace plain.toml --error 0 -o o.exr", "--error"},
                         {"trace plain.toml --error nan% -o o.exr", "--error"},
                         {"trace plain.toml --checkpoint 10m -o o.exr", "10min"},
                         {"trace plain.toml --checkpoint -1s -o o.exr", "--checkpoint"},
                         {"trace plain.toml", "--resume"}}) {
    const Outcome outcome = run(folder, std::string("parhelion ") + command);
    CHECK_MESSAGE(outcome.exit == 2, std::string(command) << " said " << outcome.err);
    CHECK_MESSAGE(outcome.err.find(says) != std::string::npos, std::string(command) << " said " << outcome.err);
  }
  CHECK(isSame(folder, "t.exr", "before.exr"));
  CHECK_FALSE(std::filesystem::exists(folder / "o.exr"));
}

TEST_CASE("a run that is good enough ends after the same rays with any number of threads, resumed or not") {
  const LongRuns folder;
  const std::string goal = " --quiet --rays 100M --error 20% ";
  REQUIRE(run(folder, "parhelion trace mirror.toml -o whole.exr --stats s.json --nthreads 1" + goal).exit == 0);
  const json stats = json::parse(readFile(folder / "s.json"));
  CHECK(stats["ended_by"] == "error");
  CHECK(stats["error"].get<double>() <= 0.2);
  REQUIRE(run(folder, "parhelion trace mirror.toml -o seven.exr --nthreads 7" + goal).exit == 0);
  CHECK(isSame(folder, "seven.exr", "whole.exr"));
  REQUIRE(run(folder, "parhelion trace mirror.toml -o parts.exr --quiet --rays 100M --ray-range 0:120002").exit == 0);
  REQUIRE(run(folder, "parhelion trace mirror.toml --resume parts.exr" + goal).exit == 0);
  CHECK(isSame(folder, "parts.exr", "whole.exr"));
  const Outcome least = run(folder, "parhelion render mirror.toml -o r.exr --rays 200k --error 0.1% --progress json");
  CHECK(least.exit == 0);
  CHECK(least.err.find("more than was asked for") != std::string::npos);
  CHECK(least.err.find("\"error\": ") != std::string::npos);
}
