// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <doctest/doctest.h>

#include "picture/photograph.h"
#include "shell.h"

namespace parhelion::test {

inline const std::string kScene = R"(
[sun]
elevation = 20.0
[[population]]
name = "columns"
aspect = 1.0
orientation = "random"
[camera]
resolution = [96, 64]
fov_horizontal = 90.0
elevation = 25.0
[trace]
rays = "20k"
)";

/// A folder with a sky, its preview, the preview as a photograph that says nothing of itself, and a tally.
struct WithSky : Folder {
  WithSky() {
    writeFile(*this / "s.toml", kScene);
    REQUIRE(run(*this, "parhelion render s.toml --quiet").exit == 0);
    writePhotograph(*this / "photo.png", readPhotograph(*this / "s.png"), {});
    REQUIRE(run(*this, "parhelion trace s.toml --quiet -o hits.exr --rays 300").exit == 0);
  }
};

}  // namespace parhelion::test
