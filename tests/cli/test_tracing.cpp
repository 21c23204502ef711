// SPDX-License-Identifier: Apache-2.0
// What the command line lets choose about tracing: vector registers, samplers, the sky's symmetry.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "shell.h"
#include "trace/lane_steps.h"

using namespace parhelion::test;
using nlohmann::json;

namespace {

// Random crystals in colour under a sun with a disc, off the sun's azimuth.
const std::string kRandom = R"([[population]]
name = "columns"
orientation = "random"
[camera]
projection = "equirectangular"
azimuth = 30
elevation = 0
fov_horizontal = 360
resolution = [72, 36]
[trace]
rays = "100k"
)";

// Mirror symmetric, but not random, but for one population that is neither.
const std::string kPlates = R"([[population]]
name = "plates"
orientation = "plate"
[camera]
resolution = [64, 64]
[trace]
rays = "20k"
)";
const std::string kTurned = R"([[population]]
name = "turned"
orientation = { zenith = 60, azimuth = 40, roll = 0 }
)";

struct WithScenes : Folder {
  WithScenes() {
    writeFile(*this / "random.toml", kRandom);
    writeFile(*this / "plates.toml", kPlates);
    writeFile(*this / "turned.toml", kPlates + kTurned);
  }
};

json statsOf(const Folder& folder, const std::string& command) {
  const Outcome outcome = run(folder, command + " --quiet --stats stats.json");
  REQUIRE_MESSAGE(outcome.exit == 0, outcome.err);
  return json::parse(readFile(folder / "stats.json"));
}

}  // namespace

TEST_CASE("a tally is the same bytes with every kind of vector registers") {
  WithScenes folder;
  for (const std::string scene : {"random.toml --sampler sobol", "turned.toml --rays 100k"}) {
    const std::string trace = "parhelion trace " + scene + " ";
    CHECK(statsOf(folder, trace + "-o baseline.exr --simd baseline")["simd_lanes"] == 2);
    const json widest = statsOf(folder, trace + "-o auto.exr");
    CHECK(widest["simd_lanes"] == parhelion::laneSteps().lanes);
    const std::string baseline = readFile(folder / "baseline.exr");
    CHECK(baseline.size() > 1000);
    CHECK(readFile(folder / "auto.exr") == baseline);
    const struct {
      parhelion::Simd simd;
      const char* name;
      int lanes;
    } others[] = {{parhelion::Simd::avx2, "avx2", 4}, {parhelion::Simd::avx512, "avx512", 8}};
    const std::vector<parhelion::Simd> here = parhelion::simdHere();
    for (const auto& [simd, name, lanes] : others) {
      if (std::ranges::find(here, simd) == here.end()) {
        MESSAGE("this machine has no " << name << " registers to test");
        continue;
      }
      CHECK(statsOf(folder, trace + "-o other.exr --simd " + name)["simd_lanes"] == lanes);
      CHECK(readFile(folder / "other.exr") == baseline);
    }
  }
}

TEST_CASE("vector registers that the machine does not have are one clear line") {
  WithScenes folder;
  const std::vector<parhelion::Simd> here = parhelion::simdHere();
  if (std::ranges::find(here, parhelion::Simd::avx512) != here.end()) {
    MESSAGE("this machine has them all");
    return;
  }
  const Outcome outcome = run(folder, "parhelion trace plates.toml -o t.exr --simd avx512");
  CHECK(outcome.exit != 0);
  CHECK(lines(outcome.err) == 1);
}

TEST_CASE("the stats name the sampler, the symmetry that was used, the lanes and the deposits placed") {
  WithScenes folder;
  const struct {
    const char *command, *sampler, *symmetry;
  } cases[] = {
      {"parhelion render random.toml", "random", "radial"},
      {"parhelion render random.toml --sampler sobol --symmetry none", "sobol", "none"},
      {"parhelion trace plates.toml -o t.exr", "random", "mirror"},
      {"parhelion trace turned.toml -o t.exr --sampler random", "random", "auto"},
      {"parhelion trace turned.toml -o t.exr -D trace.sampler=sobol", "sobol", "auto"},
  };
  for (const auto& [command, sampler, symmetry] : cases) {
    const json stats = statsOf(folder, command);
    CHECK_MESSAGE(stats["sampler"] == sampler, command);
    CHECK_MESSAGE(stats["symmetry"] == symmetry, command);
    CHECK_MESSAGE(stats["simd_lanes"] == parhelion::laneSteps().lanes, command);
    CHECK_MESSAGE(stats["deposits_placed"] > 0, command);
  }
}

TEST_CASE(
    "the same rays place as many deposits plain and in rings, two for each as mirror images, few in a small view") {
  WithScenes folder;
  const std::string trace = "parhelion trace random.toml -o t.exr --symmetry ";
  const json plain = statsOf(folder, trace + "none"), mirrored = statsOf(folder, trace + "mirror"),
             rings = statsOf(folder, trace + "radial"),
             narrow = statsOf(folder, trace + "none -D camera.fov_horizontal=20");
  for (const json& stats : {mirrored, rings, narrow}) CHECK(stats["deposits"] == plain["deposits"]);
  // All of the sky is in view; undeviated light has no place in it.
  const auto placed = [](const json& stats) { return stats["deposits_placed"].get<std::int64_t>(); };
  CHECK(placed(plain) < plain["deposits"].get<std::int64_t>());
  CHECK(placed(rings) == placed(plain));
  CHECK(placed(mirrored) == 2 * placed(plain));
  CHECK(placed(narrow) < placed(plain) / 10);
}

TEST_CASE("rings and mirror images have the totals of the plain picture") {
  WithScenes folder;
  struct Totals {
    double intercepted, undeviated, green;
  };
  const auto totalsBy = [&](const std::string& symmetry) {
    const std::string options = " random.toml --quiet -D recon.method=none --symmetry " + symmetry;
    REQUIRE(run(folder, "parhelion trace" + options + " -o t.exr").exit == 0);
    REQUIRE(run(folder, "parhelion render" + options + " -o r.exr").exit == 0);
    const std::string tally = run(folder, "parhelion info t.exr").out, sky = run(folder, "parhelion info r.exr").out;
    const auto after = [](const std::string& text, const std::string& key, std::size_t from = 0) {
      return std::stod(text.substr(text.find(key, from) + key.size()));
    };
    return Totals{after(tally, "\nintercepted: "), after(tally, "\nundeviated: "),
                  after(sky, "mean", sky.find("channel G"))};
  };
  const Totals plain = totalsBy("none"), rings = totalsBy("radial"), mirrored = totalsBy("mirror");
  CHECK(rings.intercepted == plain.intercepted);
  CHECK(rings.undeviated == plain.undeviated);
  CHECK(mirrored.intercepted == doctest::Approx(2.0 * plain.intercepted).epsilon(1e-13));
  CHECK(mirrored.undeviated == doctest::Approx(2.0 * plain.undeviated).epsilon(1e-13));
  // Some 400,000 exits of light: known to less than 0.5 %.
  CHECK(plain.green > 0.01);
  CHECK(std::abs(rings.green / plain.green - 1.0) < 0.02);
  CHECK(std::abs(mirrored.green / plain.green - 1.0) < 0.02);
}

TEST_CASE("a symmetry that the crystals do not have is one clear error, where it was asked for") {
  WithScenes folder;
  writeFile(folder / "asks.toml", kPlates + "symmetry = \"radial\"\n");
  const struct {
    const char *command, *where, *says;
  } cases[] = {
      {"parhelion trace asks.toml -o t.exr", "asks.toml:8:12: error:", "'plates' is not in random orientation"},
      {"parhelion check asks.toml", "asks.toml:8:12: error:", "'plates' is not in random orientation"},
      {"parhelion render plates.toml --symmetry radial",
       "--symmetry 'radial':1:1: error:", "'plates' is not in random orientation"},
      {"parhelion render turned.toml -D trace.symmetry=mirror",
       "-D trace.symmetry=mirror:1:16: error:", "'turned' is not its own mirror image in the sun's vertical plane"},
  };
  for (const auto& [command, where, says] : cases) {
    const Outcome outcome = run(folder, command);
    CHECK_MESSAGE(outcome.exit == 2, command);
    CHECK_MESSAGE(outcome.err.starts_with(where), outcome.err);
    CHECK_MESSAGE(outcome.err.find(says) != std::string::npos, outcome.err);
    CHECK_MESSAGE(outcome.err.find("error:") == outcome.err.rfind("error:"), outcome.err);
    CHECK_MESSAGE(outcome.out.empty(), command);
  }
  CHECK_FALSE(std::filesystem::exists(folder / "t.exr"));
  CHECK(run(folder, "parhelion trace asks.toml -o t.exr --symmetry auto --quiet").exit == 0);
  const Outcome misspelt = run(folder, "parhelion render plates.toml --symmetry radail");
  CHECK(misspelt.exit == 2);
  CHECK(misspelt.err.find("did you mean 'radial'?") != std::string::npos);
}
