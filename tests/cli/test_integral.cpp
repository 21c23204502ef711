// SPDX-License-Identifier: Apache-2.0
// Profiles without rays, as users ask for them.
#include <algorithm>
#include <cmath>
#include <sstream>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include "shell.h"

using namespace parhelion::test;

namespace {

struct WithPrisms : Folder {
  WithPrisms() {
    writeFile(*this / "s.toml",
              "[sun]\nspectrum = 550.0\n[ice]\nindex = 1.31\n"
              "[[population]]\nname = 'short'\nshape = 'prism'\naspect = 0.5\norientation = 'random'\nweight = 2.0\n"
              "[[population]]\nname = 'long'\nshape = 'prism'\naspect = { uniform = [1.0, 3.0] }\n"
              "orientation = 'random'\n");
  }
};

std::vector<double> columnOf(const std::string& csv, int column) {
  std::vector<double> values;
  std::istringstream text(csv);
  std::string line, cell;
  std::getline(text, line);
  while (std::getline(text, line)) {
    std::istringstream cells(line);
    for (int k = 0; k <= column; ++k) std::getline(cells, cell, ',');
    values.push_back(std::stod(cell));
  }
  return values;
}

}  // namespace

TEST_CASE("a profile of several populations is integrated, and rays agree with it") {
  const WithPrisms folder;
  const Outcome integral =
      run(folder,
          "parhelion profile s.toml --engine integral --error 2% --bins 90 --summary i.json --stats "
          "t.json");
  CHECK(integral.exit == 0);
  CHECK(integral.err.find("directions") != std::string::npos);
  const Outcome rays = run(folder, "parhelion profile s.toml --rays 300k --bins 90 --summary r.json --quiet");
  CHECK(rays.exit == 0);
  const auto light = columnOf(integral.out, 2), error = columnOf(integral.out, 3), traced = columnOf(rays.out, 2),
             scatter = columnOf(rays.out, 3);
  REQUIRE(light.size() == 90);
  double chiSquare = 0.0, sum = 0.0;
  for (std::size_t k = 0; k < 90; ++k) {
    chiSquare += std::pow(light[k] - traced[k], 2.0) / (error[k] * error[k] + scatter[k] * scatter[k]);
    sum += light[k];
  }
  CHECK(chiSquare < 90.0 + 4.5 * std::sqrt(180.0));
  CHECK(std::abs(sum - 1.0) < 1e-3);

  const auto a = nlohmann::json::parse(readFile(folder / "i.json")),
             b = nlohmann::json::parse(readFile(folder / "r.json"));
  for (const auto& [key, value] : b.items()) CHECK_MESSAGE(a.contains(key), key);
  CHECK(a["rays"] == 0);
  for (const char* key : {"volume", "surface", "mean_projected_area"})
    CHECK(a[key].get<double>() == doctest::Approx(b[key].get<double>()).epsilon(5e-3));
  for (const char* key : {"g", "mean_path"}) {
    const std::string stderrKey = std::string(key) + "_stderr";
    const double difference = a[key].get<double>() - b[key].get<double>();
    CHECK(std::abs(difference) < 4.5 * std::hypot(a[stderrKey].get<double>(), b[stderrKey].get<double>()));
  }
  for (std::size_t k = 0; k < 5; ++k)
    CHECK(a["by_order"][k].get<double>() == doctest::Approx(b["by_order"][k].get<double>()).epsilon(0.01));
  const auto stats = nlohmann::json::parse(readFile(folder / "t.json"));
  CHECK(stats["engine"] == "integral");
  CHECK(stats["directions"].get<long>() > 1000);
}

TEST_CASE("a profile of some raypaths says what was filtered, as rays do") {
  const WithPrisms folder;
  const std::string command = "parhelion profile s.toml --bins 60 --paths 3-5 -D population.long.aspect=2.0 ";
  const Outcome integral = run(folder, command + "--engine integral --error 2% --stats i.json");
  CHECK(integral.exit == 0);
  CHECK(integral.err.find(" + filtered 0.8") != std::string::npos);
  const Outcome rays = run(folder, command + "--rays 300k --quiet --stats r.json");
  CHECK(rays.exit == 0);
  const auto a = nlohmann::json::parse(readFile(folder / "i.json"))["energy"],
             b = nlohmann::json::parse(readFile(folder / "r.json"))["energy"];
  for (const char* key : {"out", "filtered"})
    CHECK(a[key].get<double>() == doctest::Approx(b[key].get<double>() / b["in"].get<double>()).epsilon(0.01));
  CHECK(a["out"].get<double>() + a["filtered"].get<double>() + a["cut_off"].get<double>() ==
        doctest::Approx(1.0).epsilon(1e-12));
  // Nothing before the ring, also where the scene has the filter.
  const auto light = columnOf(integral.out, 2);
  for (std::size_t k = 0; k < 7; ++k) CHECK(light[k] < 1e-9);
  CHECK(light[7] > 0.01);
  const Outcome byScene = run(folder,
                              "parhelion profile s.toml --bins 60 -D population.long.aspect=2.0 -D trace.filter=3-5 "
                              "--engine integral --error 2%");
  CHECK(byScene.out == integral.out);
}

TEST_CASE("what cannot be integrated is one clear error, and writes nothing") {
  const WithPrisms folder;
  struct Case {
    std::string command, complaint;
  };
  for (const Case& c : std::vector<Case>{
           {"trace s.toml --engine integral -o o.exr", "it makes pictures"},
           {"map s.toml --engine integral -D population.short.orientation=lowitz -o o.csv", "short"},
           {"map s.toml --engine integral --rays 1M -o o.csv", "--rays"},
           {"map s.toml --engine mixed --tally t.exr -o o.csv", "--tally"},
           {"map s.toml --engine integral --step 0.01 -o o.csv", "--step"},
           {"map s.toml --error 1% --rays 1k -o o.csv", "--error"},
           {"paths s.toml --engine integral -D population.short.orientation=lowitz --csv o.csv", "short"},
           {"paths s.toml --engine integral --ray-for 22,0 --csv o.csv", "--ray-for"},
           {"paths s.toml --engine integral --rays 1M --csv o.csv", "--rays"},
           {"paths s.toml --engine mixed --csv o.csv", "it makes pictures"},
           {"paths s.toml --error 1% --rays 1k --csv o.csv", "--error"},
           {"render s.toml --engine integral -D population.short.orientation=lowitz -o o.exr", "short"},
           {"render s.toml --engine integral -D population.short.orientation=parry -D population.short.roll=1 -o o.exr",
            "rolls"},
           {"render s.toml --engine integral --paths '3-5, symmetry = none' -o o.exr", "symmetry"},
           {"render s.toml --engine integral --rays 1M -o o.exr", "--rays"},
           {"render s.toml --engine integral --symmetry mirror -o o.exr", "--symmetry"},
           {"render s.toml --engine integral --slice 1/2 -o o.exr", "--slice"},
           {"render s.toml --engine mixed --resume t.exr -o o.exr", "--resume"},
           {"trace s.toml --engine mixed -o o.exr", "it makes pictures"},
           {"profile s.toml --engine mixed -o o.csv", "it makes pictures"},
           {"sweep s.toml sun.elevation=10,20 --error 5% --rays 1k -o f_%d.exr", "--error"},
           {"sweep s.toml sun.elevation=10,20 --engine integral -D population.short.orientation=parry "
            "-D population.short.roll=1 -o "
            "f_%d.exr",
            "rolls"},
           {"profile s.toml --engine integral -D population.short.orientation=plate -o o.csv", "short"},
           {"profile s.toml --engine integral -D population.short.shape=pyramid -o o.csv", "short"},
           {"profile s.toml --engine integral --rays 1M -o o.csv", "--rays"},
           {"profile s.toml --engine integral --time 5s -o o.csv", "--time"},
           {"profile s.toml --engine integral --tally t.exr -o o.csv", "--tally"},
           {"profile s.toml --error 1% --rays 1k -o o.csv", "--error"}}) {
    const Outcome outcome = run(folder, "parhelion " + c.command);
    CAPTURE(c.command);
    CHECK(outcome.exit == 2);
    CHECK_MESSAGE(outcome.err.find(c.complaint) != std::string::npos, outcome.err);
    CHECK(lines(outcome.err) <= 2);
    CHECK_FALSE(std::filesystem::exists(folder / "o.csv"));
    CHECK_FALSE(std::filesystem::exists(folder / "o.exr"));
  }
}

TEST_CASE("a picture without rays has its errors, its scene and its figures") {
  const WithPrisms folder;
  const Outcome outcome = run(folder,
                              "parhelion render s.toml --engine integral --error 10% --resolution 64x64 -o o.exr "
                              "--stats t.json && parhelion info o.exr && parhelion view o.exr -o v.png");
  CHECK_MESSAGE(outcome.exit == 0, outcome.err);
  CHECK(outcome.err.find("directions") != std::string::npos);
  CHECK(outcome.out.find("Variance.Y") != std::string::npos);
  const auto stats = nlohmann::json::parse(readFile(folder / "t.json"));
  CHECK(stats["engine"] == "integral");
  CHECK(stats["rays"] == 0);
  CHECK(stats["reached"] == true);
  CHECK(stats["error"].get<double>() <= 0.1);
}

TEST_CASE("a picture takes rays for those populations alone that cannot be integrated") {
  const WithPrisms folder;
  const std::string command =
      "parhelion render s.toml --engine mixed --error 20% --rays 200k --resolution 48x48 "
      "-D population.short.orientation=parry -D population.short.tilt=1 -D population.short.roll=1 ";
  const Outcome outcome = run(folder, command + "-o o.exr --stats t.json");
  CHECK_MESSAGE(outcome.exit == 0, outcome.err);
  CHECK(outcome.err.find("rays for") != std::string::npos);
  const auto stats = nlohmann::json::parse(readFile(folder / "t.json"));
  CHECK(stats["engine"] == "mixed");
  CHECK(stats["integrated"] == std::vector<std::string>{"long"});
  CHECK(stats["traced"] == std::vector<std::string>{"short"});
  CHECK(stats["rays"].get<int>() <= 200000);
  CHECK(stats["reached"] == (stats["error"].get<double>() <= 0.2));
  CHECK(stats["traced_light"].get<double>() > 0.3);
  CHECK(stats["traced_light"].get<double>() < 0.9);
}

TEST_CASE("a map is integrated into the same table and the same picture as rays make") {
  const WithPrisms folder;
  const std::string command = "parhelion map s.toml --step 10 -D population.long.aspect=2.0 ";
  const Outcome integral = run(folder, command + "--engine integral --error 5% --stats t.json");
  CHECK_MESSAGE(integral.exit == 0, integral.err);
  CHECK(integral.err.find("directions") != std::string::npos);
  const Outcome rays = run(folder, command + "--rays 200k --quiet");
  for (const int column : {0, 1}) CHECK(columnOf(integral.out, column) == columnOf(rays.out, column));
  const auto light = columnOf(integral.out, 2), traced = columnOf(rays.out, 2);
  // The sun's own bin has the light that goes straight on.
  const auto sun = std::ranges::max_element(traced) - traced.begin();
  CHECK(light[static_cast<std::size_t>(sun)] == doctest::Approx(traced[static_cast<std::size_t>(sun)]).epsilon(0.02));
  const auto stats = nlohmann::json::parse(readFile(folder / "t.json"));
  CHECK(stats["engine"] == "integral");
  CHECK(stats["rays"] == 0);
  const Outcome picture = run(folder, command + "--engine integral --error 5% -o o.exr && parhelion info o.exr");
  CHECK_MESSAGE(picture.exit == 0, picture.err);
  CHECK(picture.out.find("36 x 19") != std::string::npos);
}

TEST_CASE("paths are integrated into the same tables as rays make, and paint a picture without rays") {
  const WithPrisms folder;
  const std::string command = "parhelion paths s.toml -D population.long.aspect=2.0 --at 22,0 --radius 3 ";
  const Outcome integral = run(folder, command + "--engine integral --error 1% --seed 4 --json i.json --stats t.json");
  CHECK_MESSAGE(integral.exit == 0, integral.err);
  CHECK(integral.err.find("directions") != std::string::npos);
  const Outcome rays = run(folder, command + "--rays 500k --quiet --json r.json");
  CHECK(rays.exit == 0);
  const auto a = nlohmann::json::parse(readFile(folder / "i.json")),
             b = nlohmann::json::parse(readFile(folder / "r.json"));
  for (const auto& [key, value] : b.items()) CHECK_MESSAGE(a.contains(key), key);
  const auto &ours = a["paths"][0], &theirs = b["paths"][0];
  for (const auto& [key, value] : theirs.items()) CHECK_MESSAGE(ours.contains(key), key);
  CHECK(ours["path"] == "3-5");
  CHECK(ours["name"] == theirs["name"]);
  CHECK(ours["share"].get<double>() ==
        doctest::Approx(theirs["share"].get<double>()).epsilon(0.1));  // of half a million rays
  const auto stats = nlohmann::json::parse(readFile(folder / "t.json"));
  CHECK(stats["reached"] == true);
  CHECK(stats["error"].get<double>() <= 0.01);
  CHECK(stats["energy"]["out"].get<double>() > 0.9999);

  const Outcome map = run(folder,
                          "parhelion paths s.toml -D population.long.aspect=2.0 -D camera.resolution=[64,64] "
                          "--engine integral --error 1% --top 3 --quiet --map o.png --csv -");
  CHECK_MESSAGE(map.exit == 0, map.err);
  CHECK(lines(map.out) == 4);
  CHECK(std::filesystem::exists(folder / "o.png"));
}

TEST_CASE("frames of a sweep are integrated once, and again where another error is asked for") {
  const WithPrisms folder;
  const std::string command =
      "parhelion sweep s.toml sun.elevation=10,40 --engine integral --resolution 32x32 -o f_%d.exr --error ";
  const Outcome first = run(folder, command + "20%");
  CHECK_MESSAGE(first.exit == 0, first.err);
  const Outcome same = run(folder, command + "20%");
  CHECK(same.err.find("2 skipped, 0 to render") != std::string::npos);
  const Outcome finer = run(folder, command + "10%");
  CHECK(finer.err.find("0 skipped, 2 to render") != std::string::npos);
  CHECK(finer.err.find("parhelion:error") != std::string::npos);
  CHECK(run(folder,
            "parhelion render s.toml -D sun.elevation=40 --engine integral --resolution 32x32 --error 10% -o "
            "r.exr && cmp r.exr f_1.exr")
            .exit == 0);
}

TEST_CASE("an error by itself is asked of the quickest engine") {
  const WithPrisms folder;
  const auto engineOf = [&](const std::string& command) {
    const Outcome outcome = run(folder, "parhelion " + command + " --overwrite --quiet --stats e.json");
    CHECK_MESSAGE(outcome.exit == 0, outcome.err);
    return nlohmann::json::parse(readFile(folder / "e.json"))["engine"].get<std::string>();
  };
  const std::string render = "render s.toml --resolution 32x32 -o o.exr --error ";
  const std::string parry =
      " -D population.short.orientation=parry -D population.short.tilt=1 -D population.short.roll=1";
  CHECK(engineOf(render + "5%") == "integral");
  CHECK(engineOf(render + "5% -D trace.rays=100k" + parry) == "mixed");
  // Columns of many tilts are dear, and a rough look takes few rays.
  const std::string columns = " -D population.short.orientation=column -D population.short.tilt=5";
  CHECK(engineOf(render + "40% -D trace.rays=100k" + columns) == "planes");
  const auto choice = nlohmann::json::parse(readFile(folder / "e.json"))["choice"];
  CHECK(choice["rays_seconds"] < choice["integral_seconds"]);
  // Something about rays is a matter of rays.
  CHECK(engineOf(render + "5% --rays 50k") == "planes");
  CHECK(engineOf(render + "5% -D trace.rays=50k --engine planes") == "planes");
  CHECK(engineOf("profile s.toml --bins 18 -o o.csv --error 5%") == "integral");
  CHECK(engineOf("map s.toml --step 10 -o o.csv --error 10%") == "integral");
  CHECK(engineOf("map s.toml --step 10 -o o.csv --error 10% -D trace.rays=50k" + parry) == "mixed");
  CHECK(engineOf("paths s.toml --csv o.csv --error 1%") == "integral");
  CHECK(run(folder, "parhelion profile s.toml -o p.csv --error 5%" + parry).err.find("short") != std::string::npos);
}

TEST_CASE("rings are found in the user's cache by the next run, with the same bits, or are made without a word") {
  const WithPrisms folder;
  const std::string render = " parhelion render s.toml --engine integral --error 5% --resolution 48x48 --stats ";
  const auto made = run(folder, "export XDG_CACHE_HOME=$PWD/cache PARHELION_CACHE_SIZE=5M &&" + render +
                                    "a.json -o a.exr &&" + render + "b.json -o b.exr && ls cache/parhelion"),
             without = run(folder, "export XDG_CACHE_HOME=$PWD/none &&" + render + "c.json -o c.exr && ls"),
             blocked = run(folder,
                           "export XDG_CACHE_HOME=$PWD/s.toml PARHELION_CACHE_SIZE=5M &&" + render + "d.json -o d.exr"),
             wrong = run(folder, "export PARHELION_CACHE_SIZE=lots &&" + render + "e.json -o e.exr");
  for (const Outcome* outcome : {&made, &without, &blocked}) CHECK_MESSAGE(outcome->exit == 0, outcome->err);
  CHECK(made.out.find(".table") != std::string::npos);
  CHECK(without.out.find("none") == std::string::npos);
  const auto directions = [&](const char* file) {
    return nlohmann::json::parse(readFile(folder / file))["directions"].get<long>();
  };
  CHECK(directions("a.json") > 0);
  CHECK(directions("b.json") == 0);
  for (const char* file : {"c.json", "d.json"}) CHECK(directions(file) == directions("a.json"));
  for (const char* file : {"b.exr", "c.exr", "d.exr"}) CHECK(readFile(folder / file) == readFile(folder / "a.exr"));
  CHECK(blocked.err.find("cache") == std::string::npos);
  CHECK(wrong.exit != 0);
  CHECK(wrong.err.find("PARHELION_CACHE_SIZE: expected a size such as 500M or 2G, or off, not 'lots'") !=
        std::string::npos);
}
