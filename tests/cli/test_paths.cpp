// SPDX-License-Identifier: Apache-2.0
// Raypaths and layers as users ask for them.
#include <doctest/doctest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/view_layers.h"
#include "picture/exr.h"
#include "picture/picture_layers.h"
#include "scene/parse_scene.h"
#include "shell.h"

using namespace parhelion::test;
using nlohmann::json;

namespace {

struct Display : Folder {
  Display() {
    writeFile(
        *this / "s.toml",
        "[sun]\nelevation = 20\n[[population]]\nname = 'plates'\norientation = 'plate'\naspect = 0.3\ntilt = 0.5\n"
        "[[population]]\nname = 'free'\n[camera]\nresolution = [64, 64]\n[trace]\nrays = '20k'\n");
    writeFile(*this / "l.toml", readFile(*this / "s.toml") +
                                    "[[layer]]\nname = 'cza'\npaths = 'circumzenithal arc'\n"
                                    "[[layer]]\nname = 'wedge'\npaths = '3-5'\n");
  }
  Outcome operator()(const std::string& command) const { return run(*this, "parhelion " + command); }
};

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::vector<float> channel(const std::filesystem::path& file, const std::string& name) {
  const parhelion::Image image = parhelion::readExr(file, parhelion::ExrColours::asStored).image;
  const auto* samples = image.find(name);
  REQUIRE_MESSAGE(samples != nullptr, name);
  return *samples;
}

}  // namespace

TEST_CASE("paths prints a table, and writes the same as CSV and JSON") {
  const Display folder;
  const Outcome table = folder("paths s.toml --quiet --top 5");
  CHECK(table.exit == 0);
  CHECK(lines(table.out) == 7);  // with the head and what is left
  CHECK(has(table.out, "22° halo"));
  CHECK(folder("paths s.toml --quiet --csv p.csv --json p.json").exit == 0);
  const std::string csv = readFile(folder / "p.csv");
  CHECK(csv.starts_with("path,population,share,stderr,azimuth_deg,elevation_deg,least_deviation_deg,name\n"));
  const json paths = json::parse(readFile(folder / "p.json"));
  double sum = 0.0;
  for (const json& path : paths["paths"]) sum += path["share"].get<double>();
  CHECK(sum == doctest::Approx(1.0).epsilon(1e-6));
  CHECK(lines(csv) == static_cast<long>(paths["paths"].size()) + 1);
  CHECK(folder("paths s.toml --quiet --csv p.csv").exit == 0);  // its own file is replaced
  const Outcome cza = folder("paths s.toml --quiet --at 0,66.1 --radius 2 --json - --top 1");
  CHECK(json::parse(cza.out)["paths"][0]["name"] == "circumzenithal arc");
  CHECK(json::parse(folder("paths l.toml --quiet --layer cza --json -").out)["paths"][0]["path"] == "1-3");
}

TEST_CASE("paths that its time has ended is done, and not interrupted") {
  const Display folder;
  const Outcome outcome = folder("paths s.toml --rays 1T --time 0.2s");
  CHECK(outcome.exit == 0);
  CHECK(has(outcome.err, "the time is over"));
  CHECK_FALSE(has(outcome.err, "interrupted"));
}

TEST_CASE("a ray for a place of the sky lights it, and is drawn with its crystal") {
  const Display folder;
  const Outcome ray = folder("paths s.toml --quiet --ray-for 0,66.1 --radius 2");
  REQUIRE(ray.exit == 0);
  const json life = json::parse(folder("replay s.toml --json --ray " + ray.out).out);
  double nearest = 180.0;
  for (const json& exit : life["exits"])
    nearest = std::min(nearest, std::abs(exit["elevation_deg"].get<double>() - 66.1));
  CHECK(nearest < 2.0);
  REQUIRE(folder("replay s.toml --svg r.svg --ray " + ray.out).exit == 0);
  CHECK(folder("replay s.toml --svg r.svg --ray " + ray.out).exit == 0);  // over its own drawing
  const std::string svg = readFile(folder / "r.svg");
  CHECK(has(svg, "<svg"));
  CHECK(has(svg, "stroke-dasharray"));  // hidden edges
  CHECK(folder("paths s.toml --quiet --rays 100 --ray-for 179,-89 --radius 0.01").exit == 1);
}

TEST_CASE("mistakes about paths and layers are told in the words of the user, with the place and a suggestion") {
  const Display folder;
  struct Mistake {
    const char *command, *reason;
  };
  for (const auto& [command, reason] :
       std::vector<Mistake>{{"paths s.toml --paths 3-x",
                             "--paths '3-x':1:3: error: 'x' is neither a kind of face nor the name of a halo"},
                            {"profile s.toml --paths 'circumzenithal ark'", "did you mean 'circumzenithal arc'?"},
                            {"paths s.toml -o p.csv", "results go to --csv, --json or --map"},
                            {"paths l.toml --layer czb", "did you mean 'cza'?"},
                            {"paths s.toml --layer cza", "the scene has no layer 'cza'"},
                            {"paths s.toml --at 20", "expected AZIMUTH,ELEVATION"},
                            {"paths s.toml --symmetry all", "expected one of crystal, orientation, none"},
                            {"render s.toml -D trace.filter='Parry arc' -o a.exr", "whose orientation is \"parry\""},
                            {"trace s.toml -D layers=population -o a.exr", "did you mean 'populations'?"}}) {
    CAPTURE(command);
    const Outcome outcome = folder(command);
    CHECK(outcome.exit == 2);
    CHECK_MESSAGE(has(outcome.err, reason), outcome.err);
  }
  CHECK_FALSE(std::filesystem::exists(folder / "a.exr"));
}

TEST_CASE("layers go from tally to picture, and are left out, relit and shown by themselves") {
  const Display folder;
  REQUIRE(folder("trace l.toml -o t.exr --quiet").exit == 0);
  CHECK(has(folder("info t.exr").out, "layers: cza, wedge, rest"));
  REQUIRE(folder("recon t.exr -o all.exr --quiet").exit == 0);
  REQUIRE(folder("recon t.exr -o half.exr --gain cza=0.5 --gain rest=0 --quiet").exit == 0);
  REQUIRE(folder("recon t.exr -o only.exr --layers cza --quiet").exit == 0);
  const auto all = channel(folder / "all.exr", "cza.G"), half = channel(folder / "half.exr", "cza.G");
  const auto only = channel(folder / "only.exr", "G");
  double most = 0.0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    most = std::max(most, static_cast<double>(all[i]));
    CHECK(half[i] == doctest::Approx(0.5 * all[i]).epsilon(1e-6));
    CHECK(only[i] == doctest::Approx(all[i]).epsilon(1e-6));
  }
  CHECK(most > 0.0);
  CHECK(folder("view all.exr --layers cza,wedge -o v.png --quiet").exit == 0);
  CHECK(folder("view t.exr --layers wedge -o w.png --quiet").exit == 0);
  for (const char* command : {"recon t.exr -o b.exr --gain czb=1", "recon t.exr -o b.exr --layers czb",
                              "view all.exr --layers czb -o b.png"}) {
    const Outcome outcome = folder(command);
    CHECK(outcome.exit == 2);
    CHECK(has(outcome.err, "did you mean 'cza'?"));
  }
  CHECK(has(folder("recon t.exr -o b.exr --gain cza=x").err, "expected NAME=X"));
}

TEST_CASE("a picture's layers are named with what was read when it was") {
  const Display folder;
  REQUIRE(folder("render l.toml -o all.exr --quiet").exit == 0);
  const std::string file = (folder / "all.exr").string();
  const parhelion::cli::ViewInput all = parhelion::cli::readViewInput(file, {}, {}, true),
                                  some = parhelion::cli::readViewInput(file, {}, {"wedge"}, true),
                                  plain = parhelion::cli::readViewInput(file, {}, {});
  const std::vector<float> wedge = channel(file, "wedge.G"), green = channel(file, "G");
  std::filesystem::remove(file);
  CHECK(parhelion::layersOf(all.layers).size() == 3);
  CHECK(plain.layers.channels.empty());
  CHECK(*all.light->find("G") == green);
  CHECK(*plain.light->find("G") == green);
  CHECK(*some.light->find("G") == wedge);
  parhelion::OverlaySettings overlay;
  overlay.halos = overlay.labels = overlay.belowHorizon = true;
  const parhelion::CameraSettings camera = parhelion::loadScene(folder / "l.toml").scene.camera;
  const auto names = parhelion::cli::layerNames(all, camera, {}, overlay);
  REQUIRE_FALSE(names.empty());
  CHECK(names.front().text == "circumzenithal arc");
  CHECK(parhelion::cli::layerNames(some, camera, {"cza"}, overlay).size() == 1);
  CHECK(parhelion::cli::layerNames(plain, camera, {}, overlay).empty());
  CHECK(folder("render l.toml -o all.exr --quiet").exit == 0);
  CHECK(folder("view all.exr --layers wedge --overlay -o v.png --quiet").exit == 0);
}

TEST_CASE("the sky is painted by paths with a legend beside it") {
  const Display folder;
  REQUIRE(folder("paths s.toml --map m.png --quiet").exit == 0);
  const std::string info = folder("info m.png").out;
  CHECK_FALSE(has(info, "PNG, 64 x 64"));  // wider, by the legend
  CHECK(std::filesystem::file_size(folder / "m.png") > 2000);
}
