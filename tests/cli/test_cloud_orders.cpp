// SPDX-License-Identifier: Apache-2.0
// Light that a cloud scatters more than once, as the commands have it.
#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include <nlohmann/json.hpp>

#include "picture/exr.h"
#include "picture/temporary_directory.h"
#include "shell.h"

using namespace parhelion;
using namespace parhelion::test;

namespace {

const std::string kScene = R"(
[sun]
elevation = 20.0
[[population]]
name = "plates"
aspect = 0.3
orientation = "plate"
tilt = 1.0
[[population]]
name = "haze"
shape = "haze"
[cloud]
optical_depth = 0.5
orders = "all"
[[layer]]
name = "twice"
order = 2
[camera]
resolution = [32, 32]
[trace]
rays = "100k"
)";

std::vector<float> greenOf(const std::filesystem::path& exr, const char* channel = "G") {
  return *readExr(exr).image.find(channel);
}

}  // namespace

TEST_CASE("render, recon and sweep have the same light of all orders, on any number of threads") {
  const TemporaryDirectory folder;
  writeFile(folder / "s.toml", kScene);
  REQUIRE(run(folder, "parhelion render s.toml -o r.exr --quiet --nthreads 1 --stats r.json").exit == 0);
  REQUIRE(run(folder, "parhelion trace s.toml -o t.exr --quiet").exit == 0);
  REQUIRE(run(folder, "parhelion recon t.exr -o again.exr --quiet --stats again.json --nthreads 3").exit == 0);
  REQUIRE(run(folder, "parhelion sweep s.toml sun.elevation=20,25 -o f_%d.exr --quiet").exit == 0);
  const std::vector<float> shown = greenOf(folder / "r.exr");
  CHECK(greenOf(folder / "again.exr") == shown);
  CHECK(greenOf(folder / "f_0.exr") == shown);
  REQUIRE(run(folder, "parhelion render s.toml -o one.exr --quiet -D cloud.orders=1 -D layer=").exit == 0);
  const std::vector<float> one = greenOf(folder / "one.exr"), twice = greenOf(folder / "r.exr", "twice.G");
  double all = 0.0, first = 0.0, second = 0.0;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    all += static_cast<double>(shown[i]);
    first += static_cast<double>(one[i]);
    second += static_cast<double>(twice[i]);
  }
  CHECK(second > 0.1 * first);
  CHECK(all > first + second);

  for (const char* file : {"r.json", "again.json"}) {
    const auto orders = nlohmann::json::parse(readFile(folder / file)).at("orders");
    double sum = orders.at("direct").get<double>() + orders.at("higher_orders").at("above").get<double>() +
                 orders.at("higher_orders").at("below").get<double>();
    for (const auto& order : orders.at("by_order"))
      sum += order.at("above").get<double>() + order.at("below").get<double>();
    CHECK(std::abs(sum - 1.0) < 1e-9);
    CHECK(orders.at("absorbed") == 0.0);
    CHECK(orders.at("left_out") == 0.0);
    CHECK(orders.at("walks") == 100'000 / 16);
  }
}

TEST_CASE("a picture without rays gets its further orders by rays") {
  const TemporaryDirectory folder;
  writeFile(folder / "s.toml", kScene);
  const std::string render = "parhelion render s.toml --engine integral --error 10% --quiet -D layer= -D cloud.orders=";
  REQUIRE(run(folder, render + "1 -o one.exr").exit == 0);
  REQUIRE(run(folder, render + "2 -o two.exr --stats two.json").exit == 0);
  CHECK(nlohmann::json::parse(readFile(folder / "two.json")).at("orders").at("by_order").size() == 2);
  const std::vector<float> one = greenOf(folder / "one.exr"), two = greenOf(folder / "two.exr");
  std::size_t brighter = 0;
  for (std::size_t i = 0; i < one.size(); ++i) brighter += two[i] > one[i];
  CHECK(brighter > one.size() / 2);
}
