// SPDX-License-Identifier: Apache-2.0
// What composite cannot do is said in one line, and nothing is written.
#include <doctest/doctest.h>

#include <algorithm>

#include "photographs.h"
#include "shell.h"

using namespace parhelion;
using namespace parhelion::test;

namespace {

const char* kScene = "[[population]]\nshape = \"prism\"\n[trace]\nrays = 1000\n";

}  // namespace

TEST_CASE("EXIF that lies is refused with its value") {
  Folder folder;
  writeFile(folder / "scene.toml", kScene);
  for (const unsigned focal : {1u, 60000u}) {
    writeJpegWithExif(folder / "photo.jpg", landscape<std::uint8_t>(60, 40, 0.5), 1, focal);
    const Outcome outcome = run(folder, "parhelion composite photo.jpg --scene scene.toml --sun 30,20 -o out.png");
    CHECK(outcome.exit == 2);
    CHECK_MESSAGE(outcome.err.find(std::to_string(focal)) != std::string::npos, outcome.err);
    CHECK_FALSE(std::filesystem::exists(folder / "out.png"));
  }
}

TEST_CASE("a 35 mm equivalent of 0 in EXIF is unknown") {
  Folder folder;
  writeFile(folder / "scene.toml", kScene);
  writeJpegWithExif(folder / "photo.jpg", landscape<std::uint8_t>(60, 40, 0.5), 1, 0);
  const std::string command = "parhelion composite photo.jpg --scene scene.toml --sun 30,20 -o out.png";
  const Outcome without = run(folder, command);
  CHECK(without.exit == 2);
  CHECK_MESSAGE(without.err.find("does not say how wide") != std::string::npos, without.err);
  const Outcome with = run(folder, command + " --focal-35mm 24");
  CHECK(with.exit == 0);
  CHECK_MESSAGE(with.err.find("73.7 degrees from left to right, 24 mm on 35 mm film") != std::string::npos, with.err);
}

TEST_CASE("a composite that lacks something says which options give it") {
  Folder folder;
  writeFile(folder / "scene.toml", kScene);
  writePhotograph(folder / "photo.png", landscape<std::uint8_t>(60, 40, 0.5), {});
  const auto complaint = [&](const std::string& flags) {
    const Outcome outcome = run(folder, "parhelion composite photo.png -o out.png " + flags);
    CHECK(outcome.exit == 2);
    CHECK(lines(outcome.err) == 2);
    CHECK_FALSE(std::filesystem::exists(folder / "out.png"));
    return outcome.err;
  };
  CHECK(complaint("").find("--scene") != std::string::npos);
  CHECK(complaint("--scene scene.toml").find("--fov-horizontal") != std::string::npos);
  CHECK(complaint("--scene scene.toml --fov-horizontal 60").find("--sun X,Y") != std::string::npos);
  CHECK(complaint("--scene scene.toml --fov-horizontal 60 --sun 3").find("X,Y in pixels") != std::string::npos);
  CHECK(complaint("--scene scene.toml --fov-horizontal 60 --fov-vertical 50 --sun 3,4").find("more than once") !=
        std::string::npos);
  CHECK(complaint("--scene scene.toml --fov-horizontal 60 --azimuth 3").find("--elevation") != std::string::npos);
  CHECK(complaint("--scene scene.toml --halo x.exr").find("exclude") != std::string::npos);
  CHECK(complaint("--scene scene.toml --strength 1 --contrast 1").find("exclude") != std::string::npos);
}

TEST_CASE("a composite never writes over its inputs, over another output or over a corrected mask") {
  Folder folder;
  writeFile(folder / "scene.toml", kScene);
  std::filesystem::create_directory(folder / "layers");
  writePhotograph(folder / "photo.png", landscape<std::uint8_t>(90, 60, 0.5), {});
  writePhotograph(folder / "layers/sum.exr", landscape<std::uint8_t>(90, 60, 0.5), {});
  writePhotograph(folder / "layers/mask.png", skyOf(90, 60, 0.5), {});
  const std::string flags = " --scene scene.toml --fov-horizontal 60 --sun 45,20 --sun-elevation 10 --quiet ";
  for (const char* clash : {"layers/sum.exr -o out.png --layers layers", "photo.png -o layers/halo.exr --layers layers",
                            "photo.png -o out.png --mask layers/mask.png --layers layers", "photo.png -o photo.png",
                            "photo.png -o out.png --stats layers/grid.png --layers layers"}) {
    const std::string before = readFile(folder / "layers/sum.exr") + readFile(folder / "layers/mask.png");
    const Outcome outcome = run(folder, "parhelion composite " + std::string(clash) + flags);
    CHECK_MESSAGE(outcome.exit == 2, clash);
    CHECK_MESSAGE(outcome.err.find("would be written over") != std::string::npos, outcome.err);
    CHECK(readFile(folder / "layers/sum.exr") + readFile(folder / "layers/mask.png") == before);
  }
  // The mask that was found may be found again; one that was changed is its user's.
  const std::string composite = "parhelion composite photo.png -o out.png" + flags;
  REQUIRE(run(folder, composite).exit == 0);
  REQUIRE(run(folder, composite).exit == 0);
  writePhotograph(folder / "out-mask.png", skyOf(90, 60, 0.3), readPhotograph(folder / "out-mask.png").text);
  const std::string corrected = readFile(folder / "out-mask.png");
  const Outcome refused = run(folder, composite);
  CHECK(refused.exit == 1);
  CHECK(refused.err.find("--mask") != std::string::npos);
  CHECK(readFile(folder / "out-mask.png") == corrected);
  CHECK(run(folder, composite + "--mask out-mask.png").exit == 0);
}

TEST_CASE("an EXR of a photograph of codes holds linear light beyond white") {
  Folder folder;
  writeFile(folder / "scene.toml", kScene);
  writePhotograph(folder / "photo.png", landscape<std::uint8_t>(90, 60, 2.0), {});
  const Outcome outcome = run(folder,
                              "parhelion composite photo.png -o out.exr --all-sky --strength 100 --scene scene.toml "
                              "--fov-horizontal 60 --sun 45,20 --sun-elevation 10 --layers layers --quiet");
  REQUIRE_MESSAGE(outcome.exit == 0, outcome.err);
  const Photograph out = readPhotograph(folder / "out.exr"), sum = readPhotograph(folder / "layers/sum.exr");
  CHECK(out.samples == sum.samples);
  const auto& samples = std::get<std::vector<float>>(out.samples);
  CHECK(*std::max_element(samples.begin(), samples.end()) > 2.0F);
}

TEST_CASE("what is no sky of ours cannot be a halo, and options without effect are refused") {
  Folder folder;
  writeFile(folder / "scene.toml", kScene);
  writePhotograph(folder / "photo.png", landscape<std::uint8_t>(90, 60, 0.5), {});
  const std::string camera = " --fov-horizontal 60 --sun 45,20 --sun-elevation 0 --quiet -o ";
  REQUIRE(run(folder, "parhelion composite photo.png --all-sky --scene scene.toml" + camera + "done.exr").exit == 0);
  REQUIRE(run(folder, "parhelion trace scene.toml --quiet -o hits.exr").exit == 0);
  const Outcome photograph = run(folder, "parhelion composite photo.png --halo done.exr" + camera + "out.png");
  CHECK(photograph.exit == 1);
  CHECK(photograph.err.find("made from a photograph") != std::string::npos);
  const Outcome hits =
      run(folder, "parhelion composite photo.png --halo hits.exr --sun-elevation 0" + camera + "out.png");
  CHECK(hits.exit != 0);
  for (const char* vain : {"-D camera.roll=3", "-D sun.visible=true", "--all-sky --mask-out m.png"}) {
    const Outcome outcome =
        run(folder, std::string("parhelion composite photo.png --scene scene.toml ") + vain + camera + "out.png");
    CHECK_MESSAGE(outcome.exit == 2, vain);
  }
  CHECK(run(folder, "parhelion composite photo.png --all-sky --scene scene.toml" + camera + "OUT.JPG").exit == 0);
}
