// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <fstream>
#include <string>
#include <variant>

#include <doctest/doctest.h>

#include "scene/describe.h"
#include "scene/traced_keys.h"
#include "scene_support.h"

using namespace parhelion;
using namespace parhelion::test;

namespace {

const std::string kTetrahedron =
    "# four faces\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\ng 13\nf 1 3 2\ng\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

/// A folder with a scene of one mesh and the mesh's file.
class Folder {
 public:
  explicit Folder(const std::string& obj, const std::string& more = "")
      : path_(std::filesystem::temp_directory_path() / ("parhelion_mesh_" + std::to_string(++count_))) {
    std::filesystem::create_directories(path_);
    std::ofstream(path_ / "crystal.obj", std::ios::binary) << obj;
    std::ofstream(path_ / "scene.toml") << "[[population]]\nshape = 'mesh'\nmesh = 'crystal.obj'\n" << more;
  }
  ~Folder() { std::filesystem::remove_all(path_); }

  LoadedScene load() const { return loadScene(path_ / "scene.toml"); }

  /// The first complaint.
  std::string complaint() const {
    try {
      load();
    } catch (const SceneError& error) {
      const Diagnostic& first = error.diagnostics().front();
      return std::to_string(first.line) + ": " + first.message;
    }
    return {};
  }

 private:
  static inline int count_ = 0;
  std::filesystem::path path_;
};

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::string keysOf(const Scene& scene) {
  std::string all;
  for (const auto& [key, value] : tracedKeys(scene, scene.trace)) all += key + "=" + value + "\n";
  return all;
}

}  // namespace

TEST_CASE("a mesh is read from the scene's folder, and the scene carries it from then on") {
  const LoadedScene loaded = Folder(kTetrahedron).load();
  const auto& mesh = std::get<MeshSettings>(loaded.scene.populations.at(0).shape);
  REQUIRE(mesh.crystal);
  CHECK(mesh.crystal->faces().at(0).number == 13);
  CHECK(mesh.crystal->faces().at(1).number == 1);
  CHECK(has(describeScene(loaded.scene), "mesh, 4 faces"));
  // The folder is gone.
  const Scene again = parseScene(loaded.text, "").scene;
  CHECK(keysOf(again) == keysOf(loaded.scene));
  CHECK(parseScene(loaded.text, "").text == loaded.text);
}

TEST_CASE("scenes are told apart by what is in a mesh's file") {
  const std::string first = keysOf(Folder(kTetrahedron).load().scene);
  CHECK(first == keysOf(Folder("# another comment\n" + kTetrahedron).load().scene));
  std::string other = kTetrahedron;
  other.replace(other.find("v 0 0 1"), 7, "v 0 0 2");
  CHECK(first != keysOf(Folder(other).load().scene));
}

TEST_CASE("meshes that are no crystals are refused with file and line") {
  CHECK(has(Folder("v 0 0 0\nf 1 2 3\n").complaint(), "crystal.obj, line 2: this face names vertex 3"));
  CHECK(has(Folder(kTetrahedron + "f 1 2 3\n").complaint(), "crystal.obj, line 12: "));
  CHECK(has(Folder("").complaint(), "no faces"));
  CHECK(has(Folder(std::string(5 << 20, '#')).complaint(), "larger than 4 MiB"));
  CHECK(has(errorsOf("[[population]]\nshape = 'mesh'\nmesh = 'none.obj'\n").at(0).message, "none.obj: no such file"));
  CHECK(has(errorsOf("[[population]]\nshape = 'mesh'\nmesh = '/dev/zero'\n").at(0).message, "is no file"));
  CHECK(errorsOf("[[population]]\nshape = 'mesh'\n").at(0).message == "a crystal of this shape needs a 'mesh'");
  CHECK(errorsOf("[[population]]\nmesh = \"\"\"\nv 0 0 0\n\"\"\"\n").size() >= 1);
}

TEST_CASE("pits of prisms are one for both ends, or one for each") {
  const auto both = std::get<PrismSettings>(populationWith("cavity = { depth = 0.4, width = 0.7 }").shape);
  CHECK(both.upper.cavity == Cavity{0.4, 0.7});
  CHECK(both.lower.cavity == both.upper.cavity);
  const auto one = std::get<PrismSettings>(populationWith("lower_cavity = { depth = 1.5 }").shape);
  CHECK(!one.upper.cavity.isThere());
  CHECK(one.lower.cavity == Cavity{1.5, 0.8});
  for (const char* wrong :
       {"cavity = { width = 0.4 }", "cavity = { depth = 2 }", "cavity = { depth = 0.5, width = 1 }", "cavity = 1",
        "cavity = { depth = 1 }", "cavity = { depth = 0.5 }\naspect = { normal = [1, 0.1] }",
        "cavity = { depth = 0.5 }\nsides = [1, 2, 1, 2, 1, 2]", "shape = 'pyramid'\ncavity = { depth = 0.5 }"})
    CHECK_MESSAGE(!errorsOf(std::string("[[population]]\n") + wrong).empty(), wrong);
}

TEST_CASE("caps are one for both ends, or one for each, and notches are in all sides") {
  const auto both = std::get<PrismSettings>(populationWith("cap = { width = 3, aspect = 0.05 }").shape);
  CHECK(both.upper.cap == Cap{3.0, 0.05});
  CHECK(both.lower.cap == both.upper.cap);
  const auto one =
      std::get<PrismSettings>(populationWith("upper_cap = { width = 2.5 }\nlower_cavity = { depth = 0.5 }").shape);
  CHECK(one.upper == PrismEnd{{}, {2.5, 0.1}});
  CHECK(one.lower == PrismEnd{{0.5, 0.8}, {}});
  CHECK(std::get<PrismSettings>(populationWith("notch = { depth = 0.6, width = 0.4 }").shape).notch == Notch{0.6, 0.4});
  const std::string begin = "[[population]]\naspect = 2\n";
  CHECK(has(describeScene(sceneOf(begin + "upper_cap = { width = 2.5 }\n")),
            "prism, aspect 2, upper cap 2.5 wide, aspect 0.1"));
  CHECK(has(describeScene(sceneOf(begin + "notch = { depth = 0.5 }\n")), "aspect 2, notches 0.5 deep, 0.5 wide"));
  CHECK(errorsOf(begin + "cap = { aspect = 0.1 }").at(0).message == "'cap' needs a 'width'");
  for (const char* wrong :
       {"cap = { aspect = 0.4 }", "cap = { width = 0 }", "cap = { width = 101 }", "cap = 2",
        "cap = { width = 2, aspect = 0 }", "cap = { width = 2 }\ncavity = { depth = 0.5 }",
        "cap = { width = 2 }\nnotch = { depth = 0.5 }", "cap = { width = 2 }\nsides = [1, 2, 1, 2, 1, 2]",
        "notch = { width = 0.5 }", "notch = { depth = 1 }", "notch = { depth = 0.5, width = 1 }",
        "shape = 'pyramid'\nnotch = { depth = 0.5 }", "cap = { width = 2, depth = 0.1 }"})
    CHECK_MESSAGE(errorsOf(std::string("[[population]]\n") + wrong).size() == 1, wrong);
  CHECK(errorsOf("[[population]]\naspect = { uniform = [1, 2] }\nnotch = { depth = 0.5 }").at(0).message ==
        "a prism with pits, caps or notches has regular sides and one aspect");
  CHECK(keysOf(sceneOf(begin)) != keysOf(sceneOf(begin + "cap = { width = 2 }")));
  CHECK(keysOf(sceneOf(begin + "upper_cap = { width = 2 }")) != keysOf(sceneOf(begin + "lower_cap = { width = 2 }")));
  CHECK(keysOf(sceneOf(begin)) != keysOf(sceneOf(begin + "notch = { depth = 0.5 }")));
}

TEST_CASE("a rosette has bullets with an aspect and a slope, which may overlap") {
  const auto plain = std::get<RosetteSettings>(populationWith("shape = 'rosette'").shape);
  CHECK(plain.bullets == 6);
  CHECK(plain.overlap == 0.0);
  const auto own = std::get<RosetteSettings>(
      populationWith("shape = 'rosette'\nbullets = 4\naspect = 1.5\nslope = 30\noverlap = 0.25").shape);
  CHECK(own.bullets == 4);
  CHECK(own.aspect == 1.5);
  CHECK(own.slope == doctest::Approx(radians(30)));
  CHECK(own.overlap == 0.25);
  const std::string begin = "[[population]]\nshape = 'rosette'\n";
  CHECK(has(describeScene(sceneOf(begin + "bullets = 4\noverlap = 0.25")),
            "rosette, aspect 2, slope 28°, bullets 4, overlap 0.25"));
  CHECK(errorsOf(begin + "slope = 50").at(0).message ==
        "parts of the crystal meet in a corner or an edge alone, or nearly so");
  for (const char* wrong : {"bullets = 0", "bullets = 9", "bullets = 2.5", "overlap = -0.1", "overlap = 1.5",
                            "aspect = { normal = [1, 0.1] }", "slope = { normal = [28, 1] }", "slope = 90",
                            "upper = 0.5", "cavity = { depth = 0.4 }"})
    CHECK_MESSAGE(errorsOf(begin + wrong).size() == 1, wrong);
  CHECK(has(errorsOf("[[population]]\nbullets = 4\n").at(0).hint, "it needs shape = \"rosette\""));
  CHECK(keysOf(sceneOf(begin)) != keysOf(sceneOf(begin + "overlap = 0.25")));
}

TEST_CASE("crystals that are not convex may be in a cloud, but are not for the planes, and it is said") {
  const std::string hollow = "[[population]]\ncavity = { depth = 0.4 }\n";
  CHECK(sceneOf(hollow + "[cloud]\noptical_depth = 1\norders = 3\n").cloud);
  CHECK(errorsOf(hollow + "[trace]\nengine = 'planes'\n").at(0).message.starts_with("the planes follow light"));
  CHECK(sceneOf(hollow + "[trace]\nengine = 'embree'\n").populations.size() == 1);
}
