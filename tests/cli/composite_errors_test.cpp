// SPDX-License-Identifier: Apache-2.0
// What composite cannot do is said in one line, and nothing is written.
#include <doctest/doctest.h>

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
  for (const unsigned focal : {0u, 1u, 60000u}) {
    writeJpegWithExif(folder / "photo.jpg", landscape<std::uint8_t>(60, 40, 0.5), 1, focal);
    const Outcome outcome = run(folder, "parhelion composite photo.jpg --scene scene.toml --sun 30,20 -o out.png");
    CHECK(outcome.exit == 2);
    CHECK_MESSAGE(outcome.err.find(std::to_string(focal)) != std::string::npos, outcome.err);
    CHECK_FALSE(std::filesystem::exists(folder / "out.png"));
  }
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
