// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <ImfChannelList.h>
#include <ImfInputFile.h>
#include <ImfStandardAttributes.h>

#include "shell.h"

using namespace parhelion::test;

namespace {

/// Whether the picture that render makes with these options says that it is a latitude-longitude map.
bool isLatLong(const Folder& folder, const std::string& options) {
  const Outcome outcome =
      run(folder, "parhelion render '" PARHELION_SOURCE_DIR "/scenes/environment.toml' -o sky.exr --quiet --rays 1k " +
                      options);
  REQUIRE_MESSAGE(outcome.exit == 0, outcome.err);
  const Imf::InputFile file((folder / "sky.exr").c_str());
  const bool is = Imf::hasEnvmap(file.header()) && Imf::envmap(file.header()) == Imf::ENVMAP_LATLONG;
  // Only plain pictures have a channel whose name is of several parts.
  CHECK((file.header().channels().findChannel("Variance.Y") == nullptr) == is);
  return is;
}

}  // namespace

TEST_CASE("the level picture of the whole sphere says that it is an environment map, and no other picture does") {
  const Folder folder;
  const std::string small = "--resolution 64x32 ";
  CHECK(isLatLong(folder, small));
  CHECK(isLatLong(folder, small + "-D camera.azimuth=120"));
  CHECK_FALSE(isLatLong(folder, "--resolution 64x30"));
  CHECK_FALSE(isLatLong(folder, small + "-D camera.fov_horizontal=350"));
  CHECK_FALSE(isLatLong(folder, small + "-D camera.elevation=10"));
  CHECK_FALSE(isLatLong(folder, small + "-D camera.roll=5"));
  CHECK_FALSE(isLatLong(folder, small + "-D camera.projection=fisheye-equal-area"));
}
