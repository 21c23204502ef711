// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "picture/photograph.h"
#include "shell.h"

using namespace parhelion;
using namespace parhelion::test;

namespace {

constexpr const char* kPlates =
    "[[population]]\naspect = 0.2\norientation = \"plate\"\ntilt = 0.7\n[camera]\nresolution = [24, 16]\n"
    "[trace]\nrays = 2000\n";

/// Tallies of one scene: rays 0 to 1999, and others that do not fit.
struct Tallies {
  Folder folder;

  Tallies() {
    writeFile(folder / "s.toml", kPlates);
    trace("a", "");
    trace("seed", "--seed 2");
    trace("sun", "-D sun.elevation=21");
    trace("plain", "-D trace.symmetry=none");
    trace("spelt", "-D sun.elevation=20.0 -D recon.method=none");
  }
  void trace(const std::string& name, const std::string& options) const {
    REQUIRE(run(folder, "parhelion trace s.toml --quiet " + options + " -o " + name + ".exr").exit == 0);
  }
  Outcome operator()(const std::string& command) const { return run(folder, "parhelion " + command); }
};

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("merge refuses what does not add up, each with its reason and both names") {
  const Tallies tallies;
  struct Refused {
    const char* with;
    const char* reason;
  };
  for (const auto& [with, reason] :
       {Refused{"a.exr", "rays 0 to 1999 are in both"}, Refused{"spelt.exr", "rays 0 to 1999 are in both"},
        Refused{"seed.exr", "their seeds are 1 and 2"}, Refused{"sun.exr", "different scenes: sun.elevation differs"},
        Refused{"plain.exr", "different scenes: trace.symmetry differs"}})
    for (const std::string& command :
         {"merge a.exr " + std::string(with) + " -o m.exr", "recon a.exr " + std::string(with)}) {
      CAPTURE(command);
      const Outcome outcome = tallies(command);
      CHECK(outcome.exit == 2);
      CHECK(has(outcome.err, std::string("a.exr and ") + with));
      CHECK(has(outcome.err, reason));
      CHECK(lines(outcome.err) == 1);
    }
  CHECK_FALSE(std::filesystem::exists(tallies.folder / "m.exr"));
}

TEST_CASE("a merged tally is the tally, through files and pipes, and info says what is in it") {
  const Tallies tallies;
  const std::string whole = readFile(tallies.folder / "a.exr");
  CHECK(tallies("merge a.exr -o m.exr --complete").exit == 0);
  CHECK(readFile(tallies.folder / "m.exr") == whole);
  CHECK(tallies("merge - -o - <a.exr").out == whole);
  CHECK(tallies("merge /dev/stdin -o m2.exr <a.exr").exit == 0);
  CHECK(readFile(tallies.folder / "m2.exr") == whole);
  // From named pipes, too, also several at once.
  REQUIRE(tallies("trace s.toml --ray-range 0:1000 --quiet -o a1.exr").exit == 0);
  REQUIRE(tallies("trace s.toml --ray-range 1000:2000 --quiet -o a2.exr").exit == 0);
  const Outcome pipes = run(tallies.folder,
                            "mkfifo p1 p2; cat a1.exr > p1 & cat a2.exr > p2 & parhelion merge p2 p1 -o m3.exr; "
                            "code=$?; wait; exit $code");
  CHECK_MESSAGE(pipes.exit == 0, pipes.err);
  CHECK(readFile(tallies.folder / "m3.exr") == whole);
  const Outcome info = tallies("info m.exr");
  CHECK(info.exit == 0);
  for (const char* part :
       {"tally of a sky, 24 x 16", "rays: 2000 (rays 0 to 1999)", "scene hash: ", "numerics: 2", "symmetry: mirror"})
    CHECK(has(info.out, part));
  CHECK_FALSE(has(info.out, "missing"));
  CHECK(tallies("recon a.exr -o f.exr --quiet").exit == 0);
  CHECK(tallies("recon - -o p.exr --quiet <a.exr").exit == 0);
  CHECK(readFile(tallies.folder / "f.exr") == readFile(tallies.folder / "p.exr"));
  CHECK(tallies("recon - <a.exr").exit == 2);  // no name to call the picture by
  const Outcome wrong = tallies("merge - -o m.exr <s.toml");
  CHECK(wrong.exit == 1);
  CHECK(has(wrong.err, "stdin: not a tally"));
  CHECK(tallies("merge s.toml -o m.exr").exit == 2);
  CHECK(tallies("merge missing.exr -o m.exr").exit == 1);
}

TEST_CASE("rays that the scene asks for and the tallies have not are named, and are an error where all must be there") {
  const Tallies tallies;
  writeFile(tallies.folder / "s.toml", std::string(kPlates).replace(std::string(kPlates).find("2000"), 4, "3000"));
  // The same scene with more rays, of which the first are traced: --time ends the run before all are.
  const Outcome stopped = tallies("trace s.toml --rays 100M --time 0.2 --quiet -o part.exr");
  REQUIRE(stopped.exit == 0);
  const Outcome merged = tallies("merge part.exr -o m.exr");
  CHECK(merged.exit == 0);
  CHECK(has(merged.err, " to 99999999 are missing"));
  const Outcome complete = tallies("merge part.exr -o m2.exr --complete");
  CHECK(complete.exit == 2);
  CHECK(has(complete.err, " to 99999999 are missing"));
  CHECK_FALSE(std::filesystem::exists(tallies.folder / "m2.exr"));
  CHECK(has(tallies("info part.exr").out, "missing: "));
}

TEST_CASE("a map's or a profile's tally that needs more memory than --memory allows is refused before it is read") {
  const Tallies tallies;
  REQUIRE(tallies("map s.toml --step 0.25 --quiet --tally m.tally.exr -o /dev/null").exit == 0);
  REQUIRE(tallies("profile s.toml --bins 1000000 --quiet --tally p.tally.exr -o /dev/null").exit == 0);
  for (const std::string& command :
       std::vector<std::string>{"map m.tally.exr -o x.exr", "profile p.tally.exr -o x.csv",
                                "merge m.tally.exr -o x.exr", "merge p.tally.exr -o x.exr"}) {
    CAPTURE(command);
    const Outcome outcome = tallies(command + " --memory 30M");
    CHECK(outcome.exit == 1);
    CHECK_MESSAGE(has(outcome.err, ".tally.exr: needs about"), outcome.err);
    CHECK(has(outcome.err, "are allowed by --memory"));
    CHECK(lines(outcome.err) == 1);
    CHECK_FALSE(std::filesystem::exists(tallies.folder / "x.exr"));
    CHECK(tallies(command + " --memory 1G --overwrite").exit == 0);
    std::filesystem::remove(tallies.folder / "x.exr");
    std::filesystem::remove(tallies.folder / "x.csv");
  }
}

TEST_CASE("a damaged tally or picture is refused by every command that reads one") {
  const Tallies tallies;
  REQUIRE(tallies("recon a.exr -o sky.exr --quiet").exit == 0);
  for (const char* name : {"a.exr", "sky.exr"}) {
    std::string bytes = readFile(tallies.folder / name);
    const std::size_t at = bytes.find("elevation", bytes.find("parhelion:scene"));
    const std::size_t digit = bytes.find("0.2", bytes.find("parhelion:scene"));
    REQUIRE(at != digit);
    bytes[digit + 2] = '3';  // in the scene: another crystal
    writeFile(tallies.folder / (std::string("bad-") + name), bytes);
  }
  for (const char* command : {"info bad-a.exr", "recon bad-a.exr -o x.exr", "merge bad-a.exr -o x.exr",
                              "view bad-a.exr --unsharp 3,5 -o x.png", "recon a.exr --compare bad-a.exr -o x.exr",
                              "info bad-sky.exr", "view bad-sky.exr --unsharp 3,5 -o x.png"}) {
    CAPTURE(command);
    const Outcome outcome = tallies(command);
    CHECK(outcome.exit == 1);
    CHECK(has(outcome.err, "damaged, or changed by another program"));
    CHECK(lines(outcome.err) == 1);
  }
  writePhotograph(tallies.folder / "photo.png", readPhotograph(tallies.folder / "sky.png"), {});
  const std::string composite =
      "composite photo.png --halo bad-sky.exr --fov-horizontal 60 --sun 12,5 --all-sky "
      "--strength 1 --quiet -o c.png";
  const Outcome refused = tallies(composite);
  CHECK(refused.exit == 1);
  CHECK_MESSAGE(has(refused.err, "bad-sky.exr: damaged, or changed by another program"), refused.err);
  CHECK(lines(refused.err) == 1);
  CHECK_FALSE(std::filesystem::exists(tallies.folder / "c.png"));
  const Outcome edited = tallies(composite + " --edited");
  CHECK_MESSAGE(edited.exit == 0, edited.err);
  CHECK(std::filesystem::exists(tallies.folder / "c.png"));
  CHECK(tallies("info bad-sky.exr --edited").exit == 0);
  CHECK(tallies("view bad-sky.exr --edited --unsharp 3,5 -o x.png").exit == 0);
}
