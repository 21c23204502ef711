// SPDX-License-Identifier: Apache-2.0
// The bits of small tallies. Where one of these checksums changes, tallies of before do not fit those of now any more:
// kNumericsVersion (trace/numerics.h) goes up, and the numbers here change with it.
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "math/checksum.h"
#include "render/scenes.h"
#include "render/traced_sky.h"
#include "trace/numerics.h"

using namespace parhelion;
using namespace parhelion::test;

namespace {

std::string bitsOf(const LoadedScene& loaded) {
  const Tally tally = traceSky(loaded, cloudOf(loaded.scene)).tally.flattened();
  Checksum checksum;
  for (int pixel = 0; pixel < tally.pixels(); ++pixel)
    for (int slot = 0; slot < tally.slots(); ++slot) {
      const std::int64_t raw = tally.raw(pixel, slot);
      checksum.add(&raw, sizeof raw);
    }
  return hexOf(checksum.value());
}

struct Pinned {
  std::vector<std::string> overrides;
  std::string bits;
};

}  // namespace

TEST_CASE("tallies of the same version of the numerics have the same bits") {
  CHECK(kNumericsVersion == 2);
  for (const auto& [overrides, bits] : std::vector<Pinned>{
           {{}, "90d89b09ae722b9b"},
           {{"trace.engine=embree"}, "90d89b09ae722b9b"},
           {{"trace.path=chance", "trace.symmetry=none"}, "51510e416486b731"},
           {{"trace.sampler=sobol", "sun.spectrum=[450, 550, 650]"}, "3c2f8adb0d2c7733"},
           {{"sun.spectrum=550", "sun.diameter=0", "ice.index=[1.3, 1.32]"}, "5c81a2ae54814376"},
           {{"population.plates.shape=pyramid", "population.plates.tilt={laplace=1}"}, "4439c061d290d57d"},
           {{"population.columns.orientation=lowitz", "population.columns.aspect={normal=[2, 0.3]}"},
            "000d22e2484f468e"},
       }) {
    CAPTURE(overrides.empty() ? std::string() : overrides.front());
    CHECK(bitsOf(smallScene(overrides)) == bits);
  }
  CHECK(bitsOf(columnsScene()) == "96deea685b1588aa");
}
