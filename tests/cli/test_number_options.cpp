// SPDX-License-Identifier: Apache-2.0
// Whatever stands in the place of a number, the answer is one line that says what was expected.
#include <doctest/doctest.h>

#include "command_line.h"
#include "rendered_sky.h"

using namespace parhelion;
using namespace parhelion::test;

namespace {

const std::vector<std::string> kNoNumbers{"nan",
                                          "NaN",
                                          "-nan",
                                          "nan(1)",
                                          "inf",
                                          "-inf",
                                          "+inf",
                                          "infinity",
                                          "1e999",
                                          "-1e999",
                                          "1e-999",
                                          "0x10",
                                          "0x1p3",
                                          "0b1",
                                          "1,5.5,",
                                          "1.5.2",
                                          "5 kg",
                                          "5kg",
                                          "5°",
                                          " 5",
                                          "5 ",
                                          "\t5",
                                          "1e",
                                          "e5",
                                          ".",
                                          "-",
                                          "+",
                                          "--5",
                                          "+-5",
                                          "-+5",
                                          "++5",
                                          "1_000",
                                          "1'000",
                                          "٣",
                                          "½",
                                          "−1",
                                          "",
                                          " ",
                                          "5;5",
                                          "1/2",
                                          "1e5000",
                                          "5\n6",
                                          "1d5",
                                          "true",
                                          "%d",
                                          "$HOME",
                                          "five",
                                          "1e+",
                                          "0.1.",
                                          "1e308",
                                          "-1e308",
                                          "99999999999999999999999999",
                                          "-9223372036854775809"};

}  // namespace

TEST_CASE("every option of every command refuses what is no number in one line that says what was expected") {
  CommandLine line;
  int options = 0;
  for (const Asked& asked : line.asked()) {
    CAPTURE(asked.command);
    CAPTURE(asked.option);
    if (takesAnyText(asked)) continue;
    ++options;
    for (const std::string& text : kNoNumbers) {
      CAPTURE(text);
      const std::string complaint = line.complaintOf(asked, text);
      // Of an option without its word CLI11 itself tells, or that is how its default is asked for.
      if (text.empty() && (complaint.empty() || complaint.find("1 required") != std::string::npos)) continue;
      CHECK_MESSAGE(complaint.find("expected ") != std::string::npos, complaint);
      CHECK(complaint.size() < 400);
    }
  }
  CHECK(options > 100);
}

TEST_CASE("numbers are decimal, with a sign or without") {
  CommandLine line;
  const Asked exposure{"render", "--exposure"}, bins{"profile", "--bins"};
  for (const char* good : {"1", "+1", "-1", "+1.5", "0.5e1", "1E1", "-0", "007"})
    CHECK_MESSAGE(line.complaintOf(exposure, good) == "", good);
  for (const char* good : {"10", "+10", "0010"}) CHECK_MESSAGE(line.complaintOf(bins, good) == "", good);
  for (const char* bad : {"0", "-1", "1.5", "10000001"}) CHECK_MESSAGE(line.complaintOf(bins, bad) != "", bad);

  // A zero in front makes no octal number.
  Folder folder;
  writeFile(folder / "s.toml", kScene);
  const Outcome ten = run(folder, "parhelion profile s.toml --rays 100 --quiet --bins 010");
  CHECK(ten.exit == 0);
  CHECK(lines(ten.out) == 11);
}

TEST_CASE("numbers of a scene, of lists and of ranges that are none end with exit code 2") {
  WithSky folder;
  const std::vector<std::string> commands{
      "check s.toml -D sun.elevation=nan",
      "check s.toml -D sun.elevation=inf",
      "check s.toml -D sun.elevation=-inf",
      "check s.toml -D sun.elevation=1e999",
      "check s.toml -D sun.elevation=0x10000",
      "check s.toml -D trace.rays=nan",
      "check s.toml -D trace.rays=-1",
      "check s.toml -D trace.rays=1e300",
      "check s.toml -D trace.seed=1.5",
      "check s.toml -D trace.seed=99999999999999999999",
      "check s.toml -D camera.resolution=[nan,1]",
      "check s.toml -D camera.resolution=[99999999999,99999999999]",
      "check s.toml -D camera.resolution=[2147483648,1]",
      "check s.toml -D camera.fov_horizontal=nan",
      "check s.toml -D camera.distortion=[inf]",
      "check s.toml -D population.columns.aspect=nan",
      "check s.toml -D population.columns.aspect=1e400",
      "check s.toml -D 'population.columns.aspect={normal=[nan,1]}'",
      "check s.toml -D 'population.columns.aspect={normal=[1,inf]}'",
      "check s.toml -D population.columns.weight=-inf",
      "check s.toml -D ice.index=[nan]",
      "check s.toml -D ice.index=inf",
      "sweep s.toml sun.elevation=nan:1:1 -o f%d.exr",
      "sweep s.toml sun.elevation=0:inf:1 -o f%d.exr",
      "sweep s.toml sun.elevation=0:1:nan -o f%d.exr",
      "sweep s.toml sun.elevation=0:1:0 -o f%d.exr",
      "sweep s.toml sun.elevation=-1e308:1e308:1e-308 -o f%d.exr",
      "sweep s.toml sun.elevation=1,nan -o f%d.exr",
      "view photo.png -o v.png --unsharp nan,5",
      "view photo.png -o v.png --unsharp 3,1e999",
      "view photo.png -o v.png --unsharp 3",
      "view photo.png -o v.png --unsharp 3,5,",
      "view s.exr -o v.png --circles 22,nan",
      "view photo.png -o v.png --grid --fov-horizontal 60 --sun nan,3",
      "composite photo.png -o c.png --scene s.toml --fov-horizontal 60 --sun 1,inf",
      "composite photo.png -o c.png --scene s.toml --fov-horizontal 60 --known 1,2=nan,3",
      "composite photo.png -o c.png --scene s.toml --fov-horizontal 60 --sun 1,1 --white 1,nan,1",
      "composite photo.png -o c.png --scene s.toml --fov-horizontal 60 --sun 1,1 --distortion 0x1p3"};
  for (const std::string& command : commands) {
    const Outcome outcome = run(folder, "parhelion " + command);
    CHECK_MESSAGE(outcome.exit == 2, command << " said " << outcome.err);
    CHECK_MESSAGE(outcome.err.find("error: ") != std::string::npos, outcome.err);
  }
}

TEST_CASE("the least and the greatest numbers that options take end no command by a signal") {
  WithSky folder;
  const std::map<std::string, std::string> rest{
      {"render", "s.toml --time 0.05 --rays 2k --quiet"},
      {"trace", "s.toml --time 0.05 --rays 2k --quiet -o t.exr"},
      {"profile", "s.toml --time 0.05 --rays 2k --quiet -o p.csv"},
      {"map", "s.toml --time 0.05 --rays 2k --quiet -o m.csv"},
      {"sweep", "s.toml sun.elevation=5 --time 0.5 --rays 1k --quiet -o f%d.exr --contact-sheet sheet.png"},
      {"recon", "hits.exr --quiet"},
      {"merge", "hits.exr --quiet -o m.exr"},
      {"info", "s.toml"},
      {"check", "s.toml"},
      {"paths", "s.toml --time 0.05 --rays 2k --quiet"},
      {"replay", "s.toml"},
      {"view", "s.exr -o v.png"},
      {"composite", "photo.png --scene s.toml --rays 1k --quiet -o c.png --all-sky"}};
  const std::vector<std::string> extremes{"-1e6,-1e6=-1e6,-1e6",
                                          "0,0",
                                          "1000,4096",
                                          "1e6,1e6=1e6,1e6",
                                          "1e6,1e6,1e6",
                                          "1x1",
                                          "-360",
                                          "-100",
                                          "-90",
                                          "0",
                                          "1e-3",
                                          "0.1",
                                          "1",
                                          "64",
                                          "90",
                                          "100",
                                          "180",
                                          "360",
                                          "4096",
                                          "10000",
                                          "1e6",
                                          "1e9",
                                          "1e12",
                                          "9223372036854775807"};
  // These ask for more work or memory than a test has; the first refusal of each is tested elsewhere.
  const std::set<std::string> heavy{"--bins", "--step", "--resolution", "--rays"};
  CommandLine line;
  int runs = 0;
  for (const Asked& asked : line.asked()) {
    if (takesAnyText(asked) || heavy.contains(asked.option) || line.complaintOf(asked, "word") == "") continue;
    REQUIRE(rest.contains(asked.command));
    std::vector<std::string> accepted;
    for (const std::string& text : extremes)
      if (line.complaintOf(asked, text).empty()) accepted.push_back(text);
    if (accepted.empty()) continue;
    for (const std::string& text : std::set{accepted.front(), accepted.back()}) {
      ++runs;
      const std::string command = asked.command + " " + rest.at(asked.command) + " " + asked.option + "='" + text + "'";
      CHECK_MESSAGE(run(folder, "parhelion " + command + " --overwrite").exit < 128, command);
    }
  }
  CHECK(runs > 50);
}
