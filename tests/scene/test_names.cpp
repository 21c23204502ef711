// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <set>

#include "math/names.h"
#include "scene/describe.h"
#include "scene/scene_keys.h"
#include "scene/table_kinds.h"
#include "scene_support.h"

using namespace parhelion;
using namespace parhelion::test;

namespace {

/// That the names of a family are so many, no two alike, and read back as what they name.
template <class F>
void checkNames(std::size_t count) {
  std::set<std::string_view> seen;
  for (const std::string_view name : kNamesOf<F>) {
    CAPTURE(name);
    CHECK(!name.empty());
    CHECK(seen.insert(name).second);
    const auto member = memberNamed<F>(name);
    REQUIRE(member);
    CHECK(nameOf(*member) == name);
  }
  CHECK(seen.size() == count);
  CHECK_FALSE(memberNamed<F>(""));
  CHECK_FALSE(memberNamed<F>("no such name"));
}

std::string text(std::string_view table, std::string_view key, std::string_view name) {
  return std::string("[") + std::string(table) + "]\n" + std::string(key) + " = '" + std::string(name) +
         "'\n[[population]]\n";
}

/// A population with one distribution of its axis' zenith angle, as the summary tells it.
template <class D>
std::string summaryOf(const std::string& numbers) {
  const std::string name(D::kWords.name);
  return describeScene(
      sceneOf("[[population]]\norientation = { zenith = { " + name + " = " + numbers + " }, roll = 0 }\n"));
}

}  // namespace

TEST_CASE("every member of a family has a name of its own, which reads back") {
  checkNames<Engine>(6);
  checkNames<PathMode>(2);
  checkNames<Sampler>(2);
  checkNames<Simd>(4);
  checkNames<Symmetry>(4);
  checkNames<HitReading>(2);
  checkNames<KernelGain>(2);
  checkNames<KernelFlow>(2);
  checkNames<Projection>(11);
  checkNames<Horizon>(2);
  checkNames<ContinuousSpectrum::Source>(9);
  checkNames<Material>(6);
  checkNames<OrientationName>(5);
  checkNames<ShapeSettings>(5);
  checkNames<ReconSettings>(8);
}

TEST_CASE("names choose what they name in scene files") {
  for (const auto name : kNamesOf<Engine>) CHECK(nameOf(sceneOf(text("trace", "engine", name)).trace.engine) == name);
  for (const auto name : kNamesOf<ReconSettings>) CHECK(nameOf(sceneOf(text("recon", "method", name)).recon) == name);
  for (const auto name : kNamesOf<ShapeSettings>) {
    std::string planes = name == "planes" ? "planes = [{ normal = [1, 1, 1] }, { normal = [-1, -1, 1] }, "
                                            "{ normal = [-1, 1, -1] }, { normal = [1, -1, -1] }]\n"
                                          : "";
    if (name == "mesh")
      planes = "mesh = \"\"\"\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n\"\"\"\n";
    const Scene scene = sceneOf("[[population]]\nshape = '" + std::string(name) + "'\n" + planes);
    CHECK(nameOf(scene.populations[0].shape) == name);
  }
}

TEST_CASE("distributions are read by their words and told by them") {
  CHECK(summaryOf<Normal>("[30, 2]").find("30°, normal, sigma 2°") != std::string::npos);
  CHECK(summaryOf<UniformRange>("[30, 32]").find("30° to 32°") != std::string::npos);
  CHECK(summaryOf<PolarNormal>("[30, 2]").find("30°, polar-normal, sigma 2°") != std::string::npos);
  CHECK(summaryOf<Arcsine>("[30, 2]").find("30°, arcsine, amplitude 2°") != std::string::npos);
  CHECK(summaryOf<Laplace>("[30, 2]").find("30°, laplace, scale 2°") != std::string::npos);
}

TEST_CASE("the table of keys knows which keys a method and a shape have") {
  using Keys = std::vector<std::string_view>;
  CHECK(keysOfChosen(ReconSettings(ActSettings{})).own == Keys{"period", "reading", "iterations"});
  CHECK(keysOfChosen(ReconSettings(AdaptiveSettings{})).own.empty());
  CHECK(keysOfChosen(ReconSettings(GonzatoMarchandSettings{})).others ==
        Keys{"sigma", "scales", "period", "reading", "relaxation"});
  CHECK(keysOfChosen(PopulationKeys{.shape = PrismSettings{}}).own ==
        Keys{"aspect", "sides", "cavity", "upper_cavity", "lower_cavity", "cap", "upper_cap", "lower_cap", "notch"});
  CHECK(keysOfChosen(PopulationKeys{.shape = PyramidSettings{}}).own ==
        Keys{"aspect", "sides", "upper", "lower", "slope"});
  CHECK(keysOfChosen(PopulationKeys{.shape = PlanesSettings{}}).own == Keys{"planes"});
  CHECK(keysOfChosen(PopulationKeys{.shape = MeshSettings{}}).own == Keys{"mesh"});
  CHECK(keysOfChosen(PopulationKeys{.shape = RosetteSettings{}}).own == Keys{"aspect", "slope", "bullets", "overlap"});
}

TEST_CASE("keys fill the settings of the chosen method and leave the defaults of the others") {
  const Scene voronoi = sceneOf("[recon]\nmethod = 'voronoi'\nperiod = 4\niterations = 2\n[[population]]\n");
  const auto& settings = std::get<VoronoiSettings>(voronoi.recon);
  CHECK(settings.period == 4.0);
  CHECK(settings.iterations == 2);
  CHECK(settings.reading == VoronoiSettings{}.reading);
  CHECK(std::get<ActSettings>(sceneOf(text("recon", "method", "act")).recon).iterations == ActSettings{}.iterations);
}
