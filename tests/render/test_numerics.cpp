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
  const Tally tally = traceSky(loaded, cloudOf(loaded.scene)).tally;
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
  CHECK(kNumericsVersion == 1);
  for (const auto& [overrides, bits] : std::vector<Pinned>{
           {{}, "8db02a7749780750"},
           {{"trace.engine=embree"}, "8db02a7749780750"},
           {{"trace.path=chance", "trace.symmetry=none"}, "87eac176e793f07e"},
           {{"trace.sampler=sobol", "sun.spectrum=[450, 550, 650]"}, "e89534fd997f7bb6"},
           {{"sun.spectrum=550", "sun.diameter=0", "ice.index=[1.3, 1.32]"}, "b76ec18cb3ad57d2"},
           {{"population.plates.shape=pyramid", "population.plates.tilt={laplace=1}"}, "5ba575515c6cd3b8"},
           {{"population.columns.orientation=lowitz", "population.columns.aspect={normal=[2, 0.3]}"},
            "f121adf5a5a185bd"},
       }) {
    CAPTURE(overrides.empty() ? std::string() : overrides.front());
    CHECK(bitsOf(smallScene(overrides)) == bits);
  }
  CHECK(bitsOf(columnsScene()) == "f3fada4b043ddabf");
}
