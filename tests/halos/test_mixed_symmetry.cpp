// SPDX-License-Identifier: Apache-2.0
// Pictures whose populations count by their own symmetries, and whose rays are shared out by a pilot run, have the
// light of plain ones, and state their noise as it is.
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "render/traced_sky.h"
#include "statistics.h"

using namespace parhelion;

namespace {

/// Runs of a scene by different seeds, over the whole sphere in bins of 5 degrees, per unit of intercepted light.
struct Runs {
  std::vector<SampleMean> light;
  std::vector<double> stated;  // variance, mean over the runs

  Runs(const std::string& scene, const std::vector<std::string>& overrides, int firstSeed) {
    constexpr int kRuns = 32;
    for (int run = 0; run < kRuns; ++run) {
      std::vector<std::string> all{"camera={projection='equirectangular', fov_horizontal=360, resolution=[72, 36]}",
                                   "camera.elevation=0", "trace.rays=60000",
                                   "trace.seed=" + std::to_string(firstSeed + run)};
      all.insert(all.end(), overrides.begin(), overrides.end());
      const LoadedScene loaded =
          loadScene(std::filesystem::path(PARHELION_SOURCE_DIR) / "scenes" / (scene + ".toml"), all);
      const SkyTally tally = traceSky(loaded, cloudOf(loaded.scene)).tally;
      light.resize(static_cast<std::size_t>(tally.pixels()));
      stated.resize(light.size(), 0.0);
      for (std::size_t i = 0; i < light.size(); ++i) {
        double sum = 0.0, variance = 0.0;
        for (const SkyTally::Part& part : tally.parts()) {
          const double per = 1.0 / part.tally.info.interceptedLight();
          sum += per * part.tally.luminance(static_cast<int>(i));
          variance += std::pow(per * part.tally.luminanceError(static_cast<int>(i)), 2);
        }
        light[i].add(sum);
        stated[i] += variance / kRuns;
      }
    }
  }
};

}  // namespace

TEST_CASE("five displays have the same light in every 5 degree bin, however their rays count, and know their noise") {
  int bins = 0, far = 0;
  for (const std::string scene :
       {"display", "plates-and-pencils", "reconstruction-reference", "circumhorizontal", "environment"}) {
    CAPTURE(scene);
    const Runs mixed(scene, {}, 1), plain(scene, {"trace.symmetry='none'", "trace.allocation='light'"}, 1001);
    double stated = 0.0, scatter = 0.0;
    for (std::size_t i = 0; i < mixed.light.size(); ++i) {
      const SampleMean &a = mixed.light[i], &b = plain.light[i];
      const double error = std::hypot(a.standardError(), b.standardError());
      if (!(error > 0.0)) continue;
      // Where next to nothing was hit the runs do not know how they scatter: by chance a few hits are all faint.
      if (b.mean() < 10.0 * b.standardError()) continue;
      ++bins;
      const double sigmas = std::abs(a.mean() - b.mean()) / error;
      far += sigmas > 4.0;
      CHECK(sigmas < 6.0);
      stated += mixed.stated[i];
      scatter += a.variance();
    }
    CHECK(std::abs(stated / scatter - 1.0) < 0.1);
  }
  CHECK(bins > 5000);
  // Of 10^4 numbers with errors from 32 runs two or three are beyond four of these.
  CHECK(far <= 10);
}
