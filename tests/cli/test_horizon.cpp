// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <sstream>

#include "shell.h"

using namespace parhelion::test;

namespace {

const std::string kScenes = PARHELION_SOURCE_DIR "/scenes/";

struct Below {
  double share, error;
};

/// Light from below the horizon by the scene's map, as a share of all that is intercepted.
Below lightBelow(const Folder& folder, const std::string& scene) {
  const Outcome outcome = run(folder, "parhelion map '" + kScenes + scene + "' --rays 300k --quiet -o map.csv");
  REQUIRE_MESSAGE(outcome.exit == 0, outcome.err);
  std::istringstream lines(readFile(folder / "map.csv"));
  Below below{0.0, 0.0};
  for (std::string line; std::getline(lines, line);) {
    double azimuth = 0.0, elevation = 0.0, energy = 0.0, error = 0.0;
    if (std::sscanf(line.c_str(), "%lf,%lf,%lf,%lf", &azimuth, &elevation, &energy, &error) != 4) continue;
    const double share = elevation < 0.0 ? 1.0 : elevation == 0.0 ? 0.5 : 0.0;
    below.share += share * energy;
    below.error += share * share * error * error;
  }
  below.error = std::sqrt(below.error);
  return below;
}

}  // namespace

TEST_CASE("as much light comes from below the horizon as the documentation says") {
  const Folder folder;
  std::istringstream lines(readFile(PARHELION_SOURCE_DIR "/docs/environment-light.md"));
  int rows = 0;
  for (std::string line; std::getline(lines, line);) {
    char scene[64];
    double sun = 0.0, ofAll = 0.0, ofPicture = 0.0;
    if (std::sscanf(line.c_str(), "| `scenes/%63[^`]` | %lf\u00b0 | %lf %% | %lf %% |", scene, &sun, &ofAll,
                    &ofPicture) != 4)
      continue;
    ++rows;
    CAPTURE(std::string(scene));
    const Below below = lightBelow(folder, scene);
    // Whole per cents, and 5 sigma.
    CHECK(std::abs(100.0 * below.share - ofAll) < 0.5 + 500.0 * below.error);
    const Outcome profile = run(folder, "parhelion profile '" + kScenes + scene +
                                            "' --rays 300k --quiet -o profile.csv --summary summary.json");
    REQUIRE(profile.exit == 0);
    const std::string summary = readFile(folder / "summary.json");
    const std::size_t at = summary.find("\"delta\":");
    REQUIRE(at != std::string::npos);
    const double delta = std::strtod(summary.c_str() + at + 8, nullptr);
    CHECK(std::abs(100.0 * below.share / (1.0 - delta) - ofPicture) < 0.5 + 700.0 * below.error);
  }
  CHECK(rows == 3);
}

TEST_CASE("--no-ground is camera.horizon = cut, for every command that makes a camera, and pictures carry it") {
  const Folder folder;
  const std::string scene = "'" + kScenes + "environment.toml' --rays 3k --quiet --resolution 64x32 ";
  const auto sameFiles = [&](const std::string& command, const std::string& extension) {
    const Outcome option = run(folder, "parhelion " + command + " " + scene + "--no-ground -o a" + extension);
    REQUIRE_MESSAGE(option.exit == 0, option.err);
    const Outcome key = run(folder, "parhelion " + command + " " + scene + "-D camera.horizon=cut -o b" + extension);
    REQUIRE_MESSAGE(key.exit == 0, key.err);
    const Outcome whole = run(folder, "parhelion " + command + " " + scene + "-o c" + extension);
    REQUIRE(whole.exit == 0);
    CHECK(readFile(folder / ("a" + extension)) == readFile(folder / ("b" + extension)));
    CHECK(readFile(folder / ("a" + extension)) != readFile(folder / ("c" + extension)));
  };
  sameFiles("render", ".exr");
  sameFiles("trace", ".exr");
  // What a tally makes is what render makes.
  REQUIRE(run(folder, "parhelion recon a.exr -o r.exr && parhelion render " + scene + "--no-ground -o s.exr").exit ==
          0);
  CHECK(readFile(folder / "r.exr") == readFile(folder / "s.exr"));
  CHECK(run(folder, "parhelion info a.exr").out.find("horizon cut") != std::string::npos);
  const Outcome unknown = run(folder, "parhelion check '" + kScenes + "environment.toml' -D camera.horizon=cutt");
  CHECK(unknown.exit != 0);
  CHECK(unknown.err.find("cut") != std::string::npos);
  CHECK(run(folder, "parhelion profile '" + kScenes + "environment.toml' --no-ground -o p.csv").exit != 0);
}
