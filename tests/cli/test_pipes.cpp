// SPDX-License-Identifier: Apache-2.0
// What goes through pipes and devices are the bytes that files would hold.
#include <doctest/doctest.h>

#include <vector>

#include "rendered_sky.h"

using namespace parhelion::test;

namespace {

const std::string kProfile = "parhelion profile s.toml --rays 1k --quiet ";

struct WithProfile : Folder {
  WithProfile() {
    writeFile(*this / "s.toml", kScene);
    REQUIRE(run(*this, kProfile + "-o ref.csv").exit == 0);
    reference = readFile(*this / "ref.csv");
  }
  std::string reference;
};

/// In a shell that has <( ) and >( ).
std::string bash(const std::string& command) {
  return "export PARHELION='" PARHELION_BINARY "' && bash -c 'parhelion() { \"$PARHELION\" \"$@\"; }; " + command + "'";
}

}  // namespace

TEST_CASE("a table is the same in a file, on stdout, in an open file, in a pipe and in a named pipe") {
  WithProfile folder;
  for (const std::string& command : std::vector<std::string>{
           kProfile, kProfile + "-o -", kProfile + "-o /dev/stdout", kProfile + "-o /dev/stdout | cat",
           kProfile + "-o /dev/fd/3 3>&1", "mkfifo p; cat p & " + kProfile + "-o p; wait",
           bash("{ " + kProfile + "-o >(cat; echo done >&2) ; } 2> err; while ! [ -s err ]; do sleep 0.05; done")}) {
    const Outcome outcome = run(folder, command);
    CHECK_MESSAGE(outcome.exit == 0, command << " said " << outcome.err);
    CHECK_MESSAGE(outcome.out == folder.reference, command);
  }
  // What is in an open file already stays before it, and what follows comes behind.
  REQUIRE(run(folder, "{ echo before; " + kProfile + "-o /dev/stdout; echo behind; } > all.csv").exit == 0);
  CHECK(readFile(folder / "all.csv") == "before\n" + folder.reference + "behind\n");
  REQUIRE(run(folder, "echo before > log; " + kProfile + "-o /dev/stdout >> log").exit == 0);
  CHECK(readFile(folder / "log") == "before\n" + folder.reference);
}

TEST_CASE("a scene is the same from a file, from stdin and from a pipe, for every command that takes one") {
  WithProfile folder;
  for (const std::string& command :
       std::vector<std::string>{"cat s.toml | parhelion profile - --rays 1k --quiet",
                                "cat s.toml | parhelion profile /dev/stdin --rays 1k --quiet",
                                "parhelion profile /dev/stdin --rays 1k --quiet < s.toml",
                                "mkfifo p; cat s.toml > p & parhelion profile p --rays 1k --quiet",
                                bash("parhelion profile <(cat s.toml) --rays 1k --quiet")}) {
    const Outcome outcome = run(folder, command);
    CHECK_MESSAGE(outcome.out == folder.reference, command << " said " << outcome.err);
  }
  for (const std::string& command :
       std::vector<std::string>{"info", "check", "replay --ray 3", "map --rays 1k --quiet --step 30",
                                "trace --rays 1k --quiet -o", "info --scene"}) {
    const bool toFile = command.ends_with("-o");
    const std::string piped = run(folder, "cat s.toml | parhelion " + command + (toFile ? " - -" : " -")).out;
    const std::string direct = run(folder, "parhelion " + command + (toFile ? " - s.toml" : " s.toml")).out;
    CHECK_MESSAGE((command == "check" ? piped == "-: ok\n" : piped == direct), command);
    CHECK_FALSE(piped.empty());
  }
  // A pipe gives the scene once, and these read it for each frame and for each use.
  CHECK(run(folder, "cat s.toml | parhelion sweep - sun.elevation=1,2 --rays 1k -o f%d.exr --quiet").exit == 0);
  CHECK(std::filesystem::exists(folder / "f1.exr"));
  REQUIRE(run(folder,
              "parhelion render s.toml --rays 1k --quiet && cat s.toml | parhelion composite s.png --scene - "
              "--rays 1k --fov-horizontal 60 --sun 30,20 --sun-elevation 10 --all-sky -o c.png --quiet")
              .exit == 0);
  const std::string wrong = run(folder, "printf '[sun]\\nelevaton = 3\\n' | parhelion check -").err;
  CHECK_MESSAGE(wrong.find("stdin:2:1: error") != std::string::npos, wrong);
}

TEST_CASE("figures go to pipes, a tally to stdout, and anything into nothing") {
  WithProfile folder;
  const std::string json = run(folder, kProfile + "-o a.csv --summary j.json && cat j.json").out;
  CHECK(run(folder, kProfile + "-o a.csv --summary -").out == json);
  CHECK(run(folder, kProfile + "-o a.csv --summary /dev/stdout | cat").out == json);
  CHECK(run(folder, kProfile + "-o a.csv --stats /dev/fd/1 | cat").out.starts_with("{\n  \"rays\": 1000"));
  REQUIRE(run(folder, "parhelion trace s.toml --rays 1k --quiet -o t.exr").exit == 0);
  for (const char* output : {"- > u.exr", "- | cat > u.exr", "/dev/stdout > u.exr", "/dev/stdout | cat > u.exr"}) {
    REQUIRE(run(folder, std::string("parhelion trace s.toml --rays 1k --quiet -o ") + output).exit == 0);
    CHECK_MESSAGE(readFile(folder / "u.exr") == readFile(folder / "t.exr"), output);
  }
  CHECK(run(folder, kProfile + "-o /dev/null --summary /dev/null --stats /dev/null").exit == 0);
  const std::vector<std::string> before = folder.names();
  CHECK(run(folder, "parhelion render s.toml --rays 1k --quiet -o /dev/null").exit == 0);
  CHECK(folder.names().size() == before.size());
}

TEST_CASE("two files cannot go to one pipe, and a picture must have a name") {
  WithProfile folder;
  REQUIRE(run(folder, "parhelion trace s.toml --rays 1k --quiet -o t.exr && mkfifo p").exit == 0);
  const struct {
    std::string command;
    const char* says;
  } cases[] = {
      {"parhelion render s.toml -o -", "two files"},
      {"parhelion render s.toml -o /dev/stdout", "two files"},
      {"parhelion render s.toml -o /dev/stdout | cat; exit 2", "two files"},
      {"parhelion render s.toml -o /dev/fd/1", "two files"},
      {"parhelion render s.toml -o p", "two files"},
      {bash("parhelion render s.toml -o >(cat)"), "two files"},
      {"parhelion recon t.exr -o /dev/stdout", "two files"},
      {"cat s.toml | parhelion render -", "no name"},
      {"cat s.toml | parhelion render /dev/stdin -o " + (folder / "").string(), "no name"},
      {"parhelion profile s.toml --summary -", "written over"},
      {"parhelion profile s.toml --summary /dev/stdout | cat; exit 2", "written over"},
      {"parhelion profile s.toml -o p --summary p", "written over"},
      {"parhelion composite s.toml --scene s.toml -o x.png --mask-out -", ".png"},
  };
  for (const auto& [command, says] : cases) {
    const Outcome outcome = run(folder, command);
    CHECK_MESSAGE(outcome.exit == 2, command);
    CHECK_MESSAGE(outcome.err.find(says) != std::string::npos, command << " said " << outcome.err);
    CHECK_MESSAGE(outcome.out.empty(), command);
  }
  CHECK_FALSE(std::filesystem::exists("/dev/stdout.exr"));
}
