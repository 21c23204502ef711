// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "random_stream.h"
#include "recon/adaptive/gates.h"

namespace parhelion {

TEST_CASE("a few pixels whose density was misjudged do not decide how large the noise is") {
  constexpr int kSide = 64;
  const SkyPyramid sky(kSide, kSide, std::vector<double>(kSide * kSide, 1e-4));
  KernelSite even;
  even.density = 1.0F;
  const KernelField field(sky, Raster<KernelSite>(kSide, kSide, even));
  Raster<Light<2>> wide(kSide, kSide, {1.0F, 0.0F}), narrow = wide;
  RandomStream random(1, 0, RandomPurpose::path);
  for (std::size_t i = 0; i < narrow.size(); ++i) narrow[i][1] = static_cast<float>(0.2 * (random.next() - 0.5));
  const double ratio = compareSizes<2>(sky, field, wide, narrow, 16.0).noiseRatio;
  narrow.at(20, 30)[1] = 1e4F;
  narrow.at(40, 30)[1] = -1e3F;
  // Each counts as 10 standard deviations at most, so both together as 200 of 4096 pixels.
  CHECK(compareSizes<2>(sky, field, wide, narrow, 16.0).noiseRatio < ratio + 0.05);
}

}  // namespace parhelion
