// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "photographs.h"
#include "shell.h"

using namespace parhelion::test;
using nlohmann::json;

namespace {

const std::string kScene = R"(
[sun]
elevation = 20.0
[[population]]
orientation = "plate"
aspect = 0.3
[camera]
resolution = [64, 64]
[trace]
rays = "20k"
)";

/// A tally t.exr and two references r1.exr and r2.exr of other seeds.
struct WithTallies : Folder {
  WithTallies() {
    writeFile(*this / "s.toml", kScene);
    REQUIRE(run(*this,
                "parhelion trace s.toml -o t.exr --quiet && parhelion trace s.toml --seed 2 -o r1.exr --quiet && "
                "parhelion trace s.toml --seed 3 -o r2.exr --quiet")
                .exit == 0);
  }
};

}  // namespace

TEST_CASE("recon compares with one reference or a pair, as a table or as JSON with the same numbers") {
  WithTallies folder;
  const Outcome one = run(folder, "parhelion recon t.exr --quiet --compare r1.exr");
  CHECK(one.exit == 0);
  CHECK(one.err.empty());
  const std::vector<std::string> names = {"relMSE",       "relMSE_stderr",   "MSE",      "logMSE",   "SSIM",
                                          "energy_error", "negative_pixels", "relMSE_R", "relMSE_G", "relMSE_B",
                                          "relMSE_rgb"};
  CHECK(lines(one.out) == 7);

  const Outcome pair = run(folder, "parhelion recon t.exr --quiet --compare r1.exr r2.exr");
  const Outcome asJson = run(folder, "parhelion recon t.exr --quiet --compare r1.exr r2.exr --json");
  CHECK(lines(asJson.out) == 1);
  const json table = json::parse(asJson.out);
  CHECK(table.size() == names.size());
  std::istringstream rows(pair.out);
  std::string name, digits;
  for (const std::string& expected : names) {
    rows >> name >> digits;
    CHECK(name == expected);
    CHECK(table[name].get<double>() == std::stod(digits));
  }
  CHECK(lines(pair.out) == 11);
  CHECK(table["SSIM"] > 0.0);
  CHECK(table["SSIM"] < 1.0);
  CHECK(std::abs(table["energy_error"].get<double>()) < 0.1);
}

TEST_CASE("the drawn sun is in the picture and not in the comparison nor in the confidence view") {
  WithTallies folder;
  REQUIRE(run(folder, "parhelion trace s.toml -o sun.exr -D sun.visible=true --quiet").exit == 0);
  const Outcome without = run(folder, "parhelion recon t.exr --compare r1.exr --confidence t.png --quiet");
  const Outcome with = run(folder, "parhelion recon sun.exr --compare r1.exr --confidence sun.png --quiet");
  CHECK(with.out == without.out);
  CHECK(readFile(folder / "sun.png") == readFile(folder / "t.png"));
  CHECK(readFile(folder / "t.png").substr(1, 3) == "PNG");
  CHECK(readFile(folder / "sun-sky.png") != readFile(folder / "t-sky.png"));
}

TEST_CASE("-D overrides keys of recon, and of nothing else") {
  WithTallies folder;
  REQUIRE(run(folder, "parhelion recon t.exr --quiet -o a.exr -D recon.method=none").exit == 0);
  REQUIRE(run(folder, "parhelion recon t.exr --quiet -o b.exr --method none").exit == 0);
  CHECK(samplesOf(folder / "a.png") == samplesOf(folder / "b.png"));
  const Outcome other = run(folder, "parhelion recon t.exr -o c.exr -D sun.elevation=30");
  CHECK(other.exit == 2);
  CHECK(other.err.find("traced already") != std::string::npos);
  CHECK(other.err.find("sun.elevation=30") != std::string::npos);
  CHECK(run(folder, "parhelion recon t.exr -o c.exr -D recon.metod=none").exit == 2);
  CHECK_FALSE(std::filesystem::exists(folder / "c.exr"));
}

TEST_CASE("--method leaves the settings of the scene's own method behind") {
  WithTallies folder;
  REQUIRE(run(folder, "parhelion trace s.toml --quiet --rays 1000 -D recon.method=gaussian -D recon.sigma=3 -o g.exr")
              .exit == 0);
  CHECK(run(folder, "parhelion recon g.exr --quiet -o a.exr").exit == 0);
  CHECK(run(folder, "parhelion recon g.exr --quiet --method voronoi -o b.exr").exit == 0);
  CHECK(run(folder, "parhelion recon g.exr --quiet --method voronoi -D recon.period=4 -o c.exr").exit == 0);
  CHECK(run(folder, "parhelion recon g.exr --quiet --method voronoi -D recon.sigma=4 -o d.exr").exit == 2);
}

TEST_CASE("the stats of a reconstruction say what was done, with remarks on stderr too") {
  WithTallies folder;
  const Outcome outcome = run(folder, "parhelion recon t.exr --method gaussian --stats stats.json --nthreads 3");
  REQUIRE(outcome.exit == 0);
  const json stats = json::parse(readFile(folder / "stats.json"));
  CHECK(stats["method"] == "gaussian");
  CHECK(stats["threads"] == 3);
  CHECK(stats["width"] == 64);
  CHECK(stats["height"] == 64);
  CHECK(stats["rays"] == 20000);
  CHECK(stats["hits"] > 1000);
  CHECK(stats["seconds"] >= 0.0);
  CHECK(stats["cpu_seconds"] >= 0.0);
  CHECK(stats["peak_memory_bytes"] > 1'000'000);
  REQUIRE(stats["remarks"].size() == 1);
  CHECK(stats["remarks"][0].get<std::string>().find("sigma") != std::string::npos);
  CHECK(outcome.err.find("recon: " + stats["remarks"][0].get<std::string>() + "\n") != std::string::npos);
}

TEST_CASE("picture, confidence and comparison are the same for any number of threads") {
  WithTallies folder;
  std::string table;
  for (const std::string threads : {"1", "4"}) {
    const Outcome outcome = run(folder, "parhelion recon t.exr --quiet --compare r1.exr r2.exr -o " + threads +
                                            ".exr --confidence c" + threads + ".png --nthreads " + threads);
    REQUIRE(outcome.exit == 0);
    if (!table.empty()) CHECK(outcome.out == table);
    table = outcome.out;
  }
  CHECK(readFile(folder / "1.exr") == readFile(folder / "4.exr"));
  CHECK(readFile(folder / "c1.png") == readFile(folder / "c4.png"));
}

TEST_CASE("mistakes in what recon reads and writes are refused before anything is written") {
  WithTallies folder;
  REQUIRE(run(folder, "parhelion trace s.toml --seed 4 -D camera.azimuth=9 -o other.exr --quiet").exit == 0);
  const std::string before = readFile(folder / "r1.exr");
  const struct {
    const char *options, *says;
    int exit;
  } cases[] = {
      {"--compare other.exr", "their cameras differ", 2},
      {"--compare r1.exr r1.exr", "same rays", 2},
      {"--compare t.exr", "same rays", 2},
      {"--method none -D recon.method=gaussian", "another method", 2},
      {"--method act -D recon.iterations=0", "at least 1 iteration", 2},
      {"-o -", "stdout", 2},
      {"--compare r1.exr r2.exr t.exr", "", 2},
      {"--compare none.exr", "none.exr", 1},
      {"--json", "--compare", 2},
      {"--compare r1.exr --stats -", "written over", 2},
      {"--compare r1.exr -o r1.exr", "written over", 2},
      {"--compare r1.exr --stats r1.exr", "written over", 2},
      {"--confidence t-sky.png", "written over", 2},
      {"--confidence view.exr", ".png", 2},
      {"--stats none/x.json", "none/x.json", 1},
      {"--confidence none/x.png", "none/x.png", 1},
      {"--nthreads 0", "--nthreads", 2},
      {"--method adaptve", "did you mean 'adaptive'", 2},
  };
  for (const auto& [options, says, exit] : cases) {
    const Outcome outcome = run(folder, std::string("parhelion recon t.exr ") + options);
    CHECK_MESSAGE(outcome.exit == exit, options);
    CHECK_MESSAGE(outcome.err.find(says) != std::string::npos, options << " said " << outcome.err);
    CHECK_MESSAGE(outcome.out.empty(), options);
  }
  CHECK_FALSE(std::filesystem::exists(folder / "t-sky.exr"));
  CHECK(readFile(folder / "r1.exr") == before);
}

TEST_CASE("an interrupted reconstruction writes nothing, says so and exits 130") {
  WithTallies folder;
  REQUIRE(run(folder, "parhelion trace s.toml --resolution 1500x1500 -o big.exr --quiet").exit == 0);
  // Braces: else all of the line runs in the background, the change of folder too.
  const Outcome outcome =
      run(folder, "{ '" PARHELION_BINARY
                  "' recon big.exr --progress json --stats stats.json 2>progress & pid=$!; "
                  "while kill -0 $pid && ! [ -s progress ]; do sleep 0.01; done; kill -INT $pid; wait $pid; }");
  CHECK(outcome.exit == 130);
  const std::string progress = readFile(folder / "progress");
  CHECK(progress.find("parhelion: interrupted\n") != std::string::npos);
  CHECK(json::parse(progress.substr(0, progress.find('\n'))).contains("share"));
  CHECK_FALSE(std::filesystem::exists(folder / "big-sky.exr"));
  CHECK_FALSE(std::filesystem::exists(folder / "stats.json"));
  for (const std::string& name : folder.names()) CHECK_FALSE(name.ends_with(".tmp"));
}
