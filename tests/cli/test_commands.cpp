// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "photographs.h"
#include "shell.h"

using namespace parhelion::test;
using nlohmann::json;

namespace {

const std::string kScene = R"(
[sun]
elevation = 20.0
diameter = 0.0
spectrum = 550.0
[ice]
index = 1.31
[[population]]
name = "columns"
aspect = 1.0
orientation = "random"
[camera]
resolution = [64, 64]
[trace]
rays = "20k"
)";

struct WithScene : Folder {
  WithScene() { writeFile(*this / "s.toml", kScene); }
};

}  // namespace

TEST_CASE("render writes a linear EXR and a PNG, keeps stdout clean, and gives the same bytes again") {
  WithScene folder;
  const Outcome first = run(folder, "parhelion render s.toml");
  CHECK(first.exit == 0);
  CHECK(first.out.empty());
  CHECK(first.err.find("energy: in 1 = out 1.000000000") != std::string::npos);
  CHECK(first.err.find("exposure") != std::string::npos);
  const std::string exr = readFile(folder / "s.exr"), png = readFile(folder / "s.png");
  CHECK(exr.substr(0, 4) == "\x76\x2f\x31\x01");
  CHECK(png.substr(1, 3) == "PNG");
  CHECK(run(folder, "parhelion render s.toml -o again.exr --nthreads 1 --quiet").err.empty());
  CHECK(readFile(folder / "again.exr") == exr);
  CHECK(readFile(folder / "again.png") == png);
}

TEST_CASE("a picture can be rendered again from the scene inside it, overrides and all") {
  WithScene folder;
  const std::string command =
      "parhelion render s.toml -D sun.elevation=35 -D population.columns.aspect=2 --seed 5 --rays 5k -o a.exr --quiet";
  REQUIRE(run(folder, command).exit == 0);
  REQUIRE(run(folder, "parhelion info a.exr --scene > b.toml && parhelion render b.toml --quiet").exit == 0);
  CHECK(readFile(folder / "a.exr") == readFile(folder / "b.exr"));
  CHECK(run(folder, "parhelion info a.exr").out.find("elevation 35") != std::string::npos);
}

TEST_CASE("a tally reconstructed from disk is the picture that render makes at once, by every method") {
  WithScene folder;
  REQUIRE(run(folder, "parhelion trace s.toml -o t.exr -D sun.visible=true --quiet").exit == 0);
  for (const std::string method : {"none", "adaptive"}) {
    REQUIRE(run(folder, "parhelion recon t.exr --quiet -o a.exr --method " + method).exit == 0);
    REQUIRE(
        run(folder, "parhelion render s.toml -D sun.visible=true --quiet -o b.exr -D recon.method=" + method).exit ==
        0);
    CHECK(samplesOf(folder / "a.png") == samplesOf(folder / "b.png"));
  }
  const std::string before = readFile(folder / "t.exr");
  CHECK(run(folder, "parhelion recon t.exr").exit == 0);
  CHECK(std::filesystem::exists(folder / "t-sky.png"));
  CHECK(run(folder, "parhelion recon t.exr -o t.exr").exit == 2);
  CHECK(run(folder, "parhelion recon a.exr -o c.exr").exit == 2);
  CHECK(readFile(folder / "t.exr") == before);
}

TEST_CASE(
    "the reconstruction keeps the brightest light of sharp arcs, also where the border cuts slivers off its cells") {
  // Columns that point at the sun make rings a pixel wide; 300 pixels leave such slivers in an image circle, 301 do
  // not.
  Folder folder;
  writeFile(folder / "rings.toml",
            "[[population]]\norientation = { zenith = 90.0, azimuth = 0, roll = { uniform = [0, 360] } }\n"
            "[camera]\nelevation = 0.0\nfov_horizontal = 360.0\n[trace]\nrays = \"300k\"\n");
  const auto peak = [&](const std::string& method, const std::string& size) {
    REQUIRE(
        run(folder, "parhelion render rings.toml --quiet -D recon.method=" + method + " --resolution " + size).exit ==
        0);
    const std::string info = run(folder, "parhelion info rings.exr").out;
    const std::size_t green = info.find("channel G");
    return std::stod(info.substr(info.find("max", green) + 3));
  };
  for (const std::string size : {"300x300", "301x301"}) CHECK(peak("adaptive", size) > 0.5 * peak("none", size));
}

TEST_CASE("a picture of one pixel is made by every method") {
  WithScene folder;
  for (const std::string method : {"none", "adaptive"})
    CHECK(run(folder, "parhelion render s.toml --quiet --resolution 1x1 -D recon.method=" + method).exit == 0);
}

TEST_CASE("trace writes a tally that info understands") {
  WithScene folder;
  CHECK(run(folder, "parhelion trace s.toml -o t.exr").exit == 0);
  const Outcome info = run(folder, "parhelion info t.exr");
  CHECK(info.exit == 0);
  CHECK(info.out.find("rays: ") != std::string::npos);
}

TEST_CASE("profile prints the agreed columns and summary, and its bins add up to 1") {
  WithScene folder;
  const Outcome all = run(folder, "parhelion profile s.toml --bins 90 --summary s.json --quiet");
  CHECK(all.exit == 0);
  std::istringstream csv(all.out);
  std::string line;
  std::getline(csv, line);
  CHECK(line == "from_deg,to_deg,energy,stderr,phase");
  double sum = 0.0, solidAngles = 0.0;
  int rows = 0;
  while (std::getline(csv, line)) {
    double from, to, energy, error, phase;
    REQUIRE(std::sscanf(line.c_str(), "%lf,%lf,%lf,%lf,%lf", &from, &to, &energy, &error, &phase) == 5);
    CHECK(from == 2.0 * rows);
    CHECK(to == 2.0 * rows + 2.0);
    sum += energy;
    if (energy > 0.0) solidAngles += energy / phase;
    ++rows;
  }
  CHECK(rows == 90);
  CHECK(std::abs(sum - 1.0) < 1e-6);
  CHECK(solidAngles == doctest::Approx(1.0).epsilon(0.01));

  const json summary = json::parse(readFile(folder / "s.json"));
  for (const char* key : {"rays", "g", "g_stderr", "delta", "external", "by_order", "by_order_rest", "mean_path",
                          "volume", "surface", "mean_projected_area", "cut_off", "lost"})
    CHECK_MESSAGE(summary.contains(key), key);
  CHECK(summary["rays"] == 20000);
  CHECK(summary["by_order"][0] == summary["external"]);
  CHECK(summary["volume"].get<double>() == doctest::Approx(1.5 * std::sqrt(3.0) * 2.0));
}

TEST_CASE("map covers the sphere in whole degrees, and half bins at the poles") {
  WithScene folder;
  const Outcome map = run(folder, "parhelion map s.toml --quiet");
  CHECK(map.exit == 0);
  CHECK(lines(map.out) == 1 + 360 * 181);
  CHECK(map.out.rfind("azimuth_deg,elevation_deg,energy,stderr\n-180,-90,", 0) == 0);
  CHECK(map.out.find("\n179,90,") != std::string::npos);
  double sum = 0.0, energy = 0.0;
  std::istringstream csv(map.out);
  std::string line;
  while (std::getline(csv, line))
    if (std::sscanf(line.c_str(), "%*f,%*f,%lf", &energy) == 1) sum += energy;
  CHECK(std::abs(sum - 1.0) < 1e-6);
  CHECK(run(folder, "parhelion map s.toml --quiet --step 5 -o m.exr && parhelion info m.exr").out.find("72 x 37") !=
        std::string::npos);
}

TEST_CASE("replay tells one ray's life, in words and in data") {
  WithScene folder;
  const Outcome text = run(folder, "parhelion replay s.toml --ray 3");
  CHECK(text.exit == 0);
  CHECK(text.out.rfind("# ray 3: population 'columns', 550", 0) == 0);
  const json ray = json::parse(run(folder, "parhelion replay s.toml --ray 3 --json").out);
  CHECK(ray["hits"].size() + 1 == static_cast<std::size_t>(lines(text.out)));
  double leaving = 0.0;
  for (const json& hit : ray["hits"]) {
    for (const char* key : {"face", "point", "direction", "weight", "order"}) CHECK_MESSAGE(hit.contains(key), key);
    leaving += hit["weight"].get<double>();
  }
  CHECK(leaving == doctest::Approx(ray["weight"].get<double>()));
  CHECK(ray["orientation"].size() == 3);
  CHECK(ray["wavelength"] == 550.0);
}

TEST_CASE("the stats file holds what benchmarks read") {
  WithScene folder;
  REQUIRE(run(folder, "parhelion render s.toml --quiet --stats stats.json --nthreads 2").exit == 0);
  const json stats = json::parse(readFile(folder / "stats.json"));
  for (const char* key : {"rays", "hits", "deposits", "seconds", "cpu_seconds", "rays_per_second", "engine", "threads",
                          "peak_memory_bytes", "energy"})
    CHECK_MESSAGE(stats.contains(key), key);
  for (const char* key : {"in", "out", "absorbed", "cut_off", "lost"})
    CHECK_MESSAGE(stats["energy"].contains(key), key);
  CHECK(stats["threads"] == 2);
  CHECK(stats["rays"] == 20000);
  // Left to choose, the program says what it has chosen.
  for (const auto& [engine, traced] :
       {std::pair<std::string, std::string>{"planes", "planes"}, {"embree", "embree"}, {"auto", "planes"}}) {
    REQUIRE(run(folder, "parhelion render s.toml --quiet --stats e.json --engine " + engine).exit == 0);
    CHECK(json::parse(readFile(folder / "e.json"))["engine"] == traced);
  }
}

TEST_CASE("check accepts good scenes and shows every error of bad ones with exit 2") {
  WithScene folder;
  writeFile(folder / "bad.toml", "[sun]\nelevatoin = 3\ndiameter = -1\n[[population]]\n");
  CHECK(run(folder, "parhelion check s.toml").out == "s.toml: ok\n");
  const Outcome bad = run(folder, "parhelion check bad.toml s.toml");
  CHECK(bad.exit == 2);
  CHECK(bad.err.find("bad.toml:2:1: error:") != std::string::npos);
  CHECK(bad.err.find("did you mean 'elevation'?") != std::string::npos);
  CHECK(bad.err.find("bad.toml:3:") != std::string::npos);
  CHECK(bad.out == "s.toml: ok\n");
}

TEST_CASE("check tells what commands would refuse of a scene that is right in itself") {
  Folder folder;
  const std::string hollow = "[[population]]\nname = 'h'\ncavity = { depth = 0.4 }\norientation = 'random'\n",
                    integral = "[trace]\nengine = 'integral'\n";
  writeFile(folder / "hollow.toml", hollow + integral);
  const Outcome refused = run(folder, "parhelion check hollow.toml");
  CHECK(refused.exit == 2);
  CHECK(refused.out.empty());
  CHECK(refused.err.find("hollow.toml: error: engine integral: population h") != std::string::npos);
  // What check says is what the command says.
  for (const char* command : {"render hollow.toml", "profile hollow.toml", "paths hollow.toml"}) {
    CAPTURE(command);
    const Outcome outcome = run(folder, std::string("parhelion ") + command);
    CHECK(outcome.exit == 2);
    CHECK(outcome.err.find("engine integral: population h") != std::string::npos);
  }
  writeFile(folder / "rays.toml", hollow);
  CHECK(run(folder, "parhelion check rays.toml").out == "rays.toml: ok\n");
  writeFile(folder / "prisms.toml", "[[population]]\naspect = 1.0\norientation = 'random'\n" + integral);
  CHECK(run(folder, "parhelion check prisms.toml").exit == 0);
}

TEST_CASE("the schema is JSON, and the one in docs is the one printed") {
  Folder folder;
  const Outcome schema = run(folder, "parhelion schema");
  CHECK(schema.exit == 0);
  CHECK(json::parse(schema.out).contains("properties"));
  CHECK(schema.out == readFile(PARHELION_SOURCE_DIR "/docs/scene.schema.json"));
}

TEST_CASE("mistakes on the command line are one clear complaint and exit 2") {
  WithScene folder;
  std::filesystem::create_symlink("s.toml", folder / "link.csv");
  const struct {
    const char *command, *says;
  } cases[] = {
      {"parhelion", "subcommand is required"},
      {"parhelion rendr s.toml", "did you mean 'render'"},
      {"parhelion render", "scene is required"},
      {"parhelion render missing.toml", "no such file"},
      {"parhelion render s.toml --rays many", "--rays"},
      {"parhelion render s.toml --rays 0", "--rays"},
      {"parhelion render s.toml --seed -1", "whole number"},
      {"parhelion render s.toml --resolution 64", "WIDTHxHEIGHT"},
      {"parhelion render s.toml --engine embre", "did you mean 'embree'"},
      {"parhelion render s.toml --engine plane", "did you mean 'planes'"},
      {"parhelion render s.toml --exposure nan", "expected a number"},
      {"parhelion render s.toml --time 0", "expected a time"},
      {"parhelion render s.toml -o sky.jpg", ".exr"},
      {"parhelion profile s.toml -o s.toml", "written over"},
      {"parhelion profile s.toml -o a.csv --summary ./a.csv", "written over"},
      {"parhelion map s.toml -o link.csv", "written over"},
      {"parhelion trace s.toml -o t.exr --stats s.toml", "written over"},
      {"parhelion profile s.toml --summary -", "written over"},
      {"parhelion render s.toml -D sun.elevation=100", "-D sun.elevation=100"},
      {"parhelion profile s.toml --from 10 --to 5", "--from"},
      {"parhelion map s.toml --step 0.7", "--step"},
      {"parhelion replay s.toml --ray -1", "whole number"},
  };
  for (const auto& [command, says] : cases) {
    const Outcome outcome = run(folder, command);
    CHECK_MESSAGE(outcome.exit == 2, command);
    CHECK_MESSAGE(outcome.err.find(says) != std::string::npos, command << " said " << outcome.err);
    CHECK_MESSAGE(outcome.out.empty(), command);
  }
  CHECK_FALSE(std::filesystem::exists(folder / "s.exr"));
  CHECK(readFile(folder / "s.toml") == kScene);
}

TEST_CASE("outputs that cannot be written are one clear line, exit 1, before any ray is traced") {
  WithScene folder;
  writeFile(folder / "keep.exr", "precious");
  for (const char* command :
       {"parhelion render s.toml -o none/x.exr", "parhelion trace s.toml -o none/x.exr",
        "parhelion profile s.toml -o none/x.csv", "parhelion profile s.toml --summary none/x.json",
        "parhelion map s.toml -o none/x.csv", "parhelion render s.toml --stats none/x.json"}) {
    const Outcome outcome = run(folder, command);
    CHECK_MESSAGE(outcome.exit == 1, command);
    CHECK_MESSAGE(lines(outcome.err) == 1, outcome.err);
    CHECK_MESSAGE(outcome.err.find("none/x.") != std::string::npos, outcome.err);
    CHECK_MESSAGE(outcome.out.empty(), command);
  }
  CHECK(readFile(folder / "keep.exr") == "precious");
}

TEST_CASE("a full disk is one clear line and exit 1") {
  WithScene folder;
  for (const char* command :
       {"parhelion profile s.toml --quiet -o /dev/full", "parhelion profile s.toml --quiet > /dev/full",
        "parhelion trace s.toml --quiet -o /dev/full", "parhelion schema > /dev/full",
        "parhelion replay s.toml --ray 1 > /dev/full", "parhelion --help > /dev/full"}) {
    const Outcome outcome = run(folder, command);
    CHECK_MESSAGE(outcome.exit == 1, command);
    CHECK_MESSAGE(outcome.err.find("No space left") != std::string::npos, outcome.err);
    CHECK_MESSAGE(lines(outcome.err) == 1, outcome.err);
  }
}

TEST_CASE("a truncated or foreign EXR is one clear line and exit 1") {
  WithScene folder;
  REQUIRE(run(folder, "parhelion render s.toml --quiet").exit == 0);
  for (const char* make : {"head -c 3000 s.exr > t.exr", "head -c 100 s.exr > t.exr", "head -c 4 s.exr > t.exr"}) {
    const Outcome outcome = run(folder, std::string(make) + " && parhelion info t.exr");
    CHECK_MESSAGE(outcome.exit == 1, make);
    CHECK_MESSAGE(lines(outcome.err) == 1, outcome.err);
    CHECK_MESSAGE(outcome.err.find("t.exr") != std::string::npos, outcome.err);
  }
}

TEST_CASE("an interrupted render writes what there is, says so and exits 75") {
  WithScene folder;
  const Outcome outcome =
      run(folder, "'" PARHELION_BINARY
                  "' render s.toml --rays 20G --stats stats.json & pid=$!; sleep 1; kill -INT $pid; wait $pid");
  CHECK(outcome.exit == 75);
  CHECK(std::filesystem::exists(folder / "s.exr"));
  CHECK(std::filesystem::exists(folder / "s.png"));
  CHECK(json::parse(readFile(folder / "stats.json"))["interrupted"] == true);
  CHECK(outcome.err.find("interrupted") != std::string::npos);
}

TEST_CASE("a run that reaches its time limit ends well with the rays it has") {
  WithScene folder;
  CHECK(run(folder, "parhelion render s.toml --rays 20G --time 0.5 --quiet --stats stats.json").exit == 0);
  const json stats = json::parse(readFile(folder / "stats.json"));
  CHECK(stats["rays"].get<double>() > 0);
  CHECK(stats["rays"].get<double>() < 20e9);
}
