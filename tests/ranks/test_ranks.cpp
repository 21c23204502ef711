// SPDX-License-Identifier: Apache-2.0
// Many processes make the same files as one, and a lost one costs no more than what came after the last checkpoint.
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "cli/shell.h"
#include "sky/tally_exr.h"

using namespace parhelion::test;

namespace {

/// Runs a shell command in `folder`, with `parhelion` and `ranks N ...`, which is the same program in N processes.
Outcome runRanks(const Folder& folder, const std::string& command) {
  return run(
      folder,
      "export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_btl_base_warn_component_unused=0; "
      "ranks() { n=$1; shift; '" PARHELION_MPIEXEC "' --bind-to none --oversubscribe -n $n '" PARHELION_MPI_BINARY
      "' \"$@\"; }; " +
          command);
}

std::string scene(const std::string& population, const std::string& trace = {}) {
  return "[sun]\nelevation = 20\n[[population]]\nshape = 'prism'\n" + population +
         "[camera]\nprojection = 'fisheye-equal-area'\nelevation = 90\nfov_horizontal = 180\nresolution = [41, 40]\n"
         "[trace]\nrays = 200_001\n" +
         trace;
}

const std::string kPlates = "aspect = 0.2\norientation = 'plate'\ntilt = 1.0\n";

}  // namespace

TEST_CASE("one, two and three ranks of one and two threads make the same tally as one process") {
  Folder folder;
  writeFile(folder / "mirrored.toml", scene(kPlates));
  writeFile(folder / "plain.toml", scene(kPlates, "symmetry = 'none'\n"));
  writeFile(folder / "radial.toml", scene("aspect = 1.0\norientation = 'random'\n"));
  writeFile(folder / "layered.toml", scene(kPlates + "[[population]]\nweight = 0.5\n") +
                                         "[[layer]]\nname = 'wedge'\npaths = '3-5'\n"
                                         "[[layer]]\nname = 'ends'\npaths = '*-basal-*'\n");
  for (const std::string name : {"mirrored", "plain", "radial", "layered"}) {
    REQUIRE(runRanks(folder, "parhelion trace " + name + ".toml -o " + name + ".exr --quiet").exit == 0);
    for (const std::string ranks : {"1", "2", "3"})
      for (const std::string threads : {"1", "2"}) {
        CAPTURE(name + " by " + ranks + " ranks of " + threads + " threads");
        const Outcome outcome = runRanks(folder, "ranks " + ranks + " trace " + name + ".toml --nthreads " + threads +
                                                     " -o sum.exr --quiet && cmp sum.exr " + name + ".exr");
        CHECK_MESSAGE(outcome.exit == 0, outcome.out << outcome.err);
      }
  }
}

TEST_CASE("map, profile and picture by three ranks are those of one process") {
  Folder folder;
  writeFile(folder / "s.toml", scene(kPlates));
  const Outcome outcome =
      runRanks(folder,
               "for who in 'ranks 3' parhelion; do n=${who#ranks }; "
               "$who map s.toml --step 10 -o map-$n.csv --quiet && "
               "$who profile s.toml --bins 90 -o profile-$n.csv --summary summary-$n.json --quiet && "
               "$who render s.toml -o sky-$n.exr --quiet || exit; done; "
               "for f in map profile; do cmp $f-3.csv $f-parhelion.csv || exit; done; "
               "cmp summary-3.json summary-parhelion.json && cmp sky-3.exr sky-parhelion.exr && "
               "cmp sky-3.png sky-parhelion.png");
  CHECK_MESSAGE(outcome.exit == 0, outcome.out << outcome.err);
}

TEST_CASE("a scene that is wrong is told once, whatever the number of ranks") {
  Folder folder;
  writeFile(folder / "s.toml", "[sun]\nelevatoin = 20\n");
  const Outcome outcome = runRanks(folder, "ranks 3 trace s.toml -o t.exr");
  CHECK(outcome.exit == 2);
  const std::size_t at = outcome.err.find("elevatoin");
  REQUIRE(at != std::string::npos);
  CHECK(outcome.err.find("s.toml:2", outcome.err.find("s.toml:2") + 1) == std::string::npos);
}

TEST_CASE("a run that has lost a rank says what is on disk, and another goes on from there") {
  Folder folder;
  writeFile(folder / "s.toml", scene(kPlates));
  // The last of the processes is killed when there is a checkpoint.
  const Outcome lost = runRanks(folder,
                                "{ ranks 2 trace s.toml --rays 4G -o t.exr --checkpoint 0.3s --quiet & } ; "
                                "for i in $(seq 300); do [ -f t.exr ] && break; sleep 0.1; done; sleep 0.5; "
                                "kill -KILL $(for p in /proc/[0-9]*; do [ \"$(readlink $p/cwd)\" = \"$PWD\" ] && "
                                "[ \"$(readlink $p/exe)\" = '" PARHELION_MPI_BINARY
                                "' ] && echo ${p#/proc/}; done | sort -n | tail -1); wait");
  CHECK(lost.err.find("--resume t.exr") != std::string::npos);
  // It held whole batches from ray 0 on; 2000 rays more are enough to see that the bits are right.
  const std::string rays = std::to_string(parhelion::readTallyExr(folder / "t.exr").info.rayCount() + 2000);
  const Outcome resumed = runRanks(folder, "parhelion trace s.toml --rays " + rays +
                                               " --resume t.exr -o resumed.exr --quiet && ranks 2 trace "
                                               "s.toml --rays " +
                                               rays + " -o whole.exr --quiet && cmp resumed.exr whole.exr");
  CHECK_MESSAGE(resumed.exit == 0, resumed.out << resumed.err);
}

TEST_CASE("what ranks send for their sums is 64 bytes a pixel from each but the first") {
  Folder folder;
  writeFile(folder / "s.toml", scene(kPlates));
  REQUIRE(runRanks(folder, "ranks 3 trace s.toml -o t.exr --stats s.json --quiet").exit == 0);
  const std::string stats = readFile(folder / "s.json");
  const std::string key = "\"bytes_reduced\": ";
  REQUIRE(stats.find(key) != std::string::npos);
  const long bytes = std::stol(stats.substr(stats.find(key) + key.size()));
  CHECK(bytes >= 2 * 64 * 41 * 40);
  CHECK(bytes < 2 * (64 * 41 * 40 + 1000));  // totals of the run
  CHECK(stats.find("\"ranks\": 3") != std::string::npos);
}
