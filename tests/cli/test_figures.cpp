// SPDX-License-Identifier: Apache-2.0
// The figures of photographs, views and sweeps are made by a script: here from stand-ins of the sizes it expects.
#include <doctest/doctest.h>

#include "photographs.h"
#include "shell.h"

using namespace parhelion;
using namespace parhelion::test;

namespace {

/// A whole sphere: a bright sky over dark ground, linear.
Photograph panorama() {
  Photograph picture;
  picture.width = 512;
  picture.height = 256;
  std::vector<float> samples;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x)
      samples.insert(samples.end(), 3, y < picture.height / 2 ? 0.8F + 0.001F * static_cast<float>(y) : 0.05F);
  picture.samples = std::move(samples);
  return picture;
}

}  // namespace

TEST_CASE("the script that makes the figures of photographs, views and sweeps runs") {
  Folder folder;
  writeJpegWithExif(folder / "evening.jpg", landscape<std::uint8_t>(2560, 1600, 0.35), 1, 16);
  writePhotograph(folder / "sunset.exr", panorama(), {});
  const Outcome outcome = run(folder, "PARHELION='" PARHELION_BINARY "' RAYS=20k HITS=2k '" PARHELION_SOURCE_DIR
                                      "/scripts/figures' "
                                      "\"$PWD\" \"$PWD\"");
  CHECK_MESSAGE(outcome.exit == 0, outcome.err);
  const Photograph figure = readPhotograph(folder / "evening-figure.png");
  CHECK(figure.width == 5 * 427 + 4 * 4);  // five pictures and the gaps between them
  CHECK(figure.height == 267);
  CHECK(readPhotograph(folder / "panorama-halo.png").width == 512);
  CHECK(readPhotograph(folder / "views.png").width == 4 * 480 + 3 * 4);
  CHECK(readFile(folder / "views-profile.svg").find("<svg") != std::string::npos);
  for (const char* sheet : {"sweep.png", "sunrise.png", "thin-to-thick-depths.png"})
    CHECK(readPhotograph(folder / sheet).width > 800);
}
