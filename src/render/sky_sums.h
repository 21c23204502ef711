// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/run_sums.h"
#include "render/traced_sky.h"

namespace parhelion {

/// The tally of a scene's camera as the sums of a run.
class SkySums : public RunSums {
 public:
  /// `loaded` and `cloud`, which is its scene's, must outlive it.
  SkySums(const LoadedScene& loaded, const Cloud& cloud)
      : loaded_(loaded), cloud_(cloud), tally_(emptyTally(loaded, cloud)) {}

  Film& film() override;
  Measurement measurement() const override { return SkyMeasurement{}; }
  TallyOrigin& origin() override { return tally_.info(); }
  TallyKind kind() const override { return TallyKind::sky; }
  void read(const std::filesystem::path& path) override;
  void write(const Output& file) const override;
  std::unique_ptr<RunSums> empty() const override { return std::make_unique<SkySums>(loaded_, cloud_); }
  void subtract(RunSums& other) override;

  /// With the rays that it holds noted in all parts.
  const SkyTally& tally() {
    tally_.shareOrigin();
    return tally_;
  }

 private:
  const LoadedScene& loaded_;
  const Cloud& cloud_;
  SkyTally tally_;
  std::unique_ptr<Film> film_;
};

}  // namespace parhelion
