// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/ranks/ranks.h"
#include "render/tracers.h"

namespace parhelion {

/// All ranks of a run, as rank 0 has them at its command. The others are in serveRank0() as long as this lives.
class RankTracers : public Tracers {
 public:
  explicit RankTracers(Ranks& ranks) : ranks_(ranks) {}
  ~RankTracers() override;

  std::unique_ptr<RayTracer> make(const Cloud& cloud, const TraceSettings& settings, RunSums& sums, int threads,
                                  Simd simd) override;
  int processes() const override { return ranks_.count(); }
  std::uint64_t bytesReduced() const override {
    return static_cast<std::uint64_t>(ranks_.count() - 1) * ranks_.bytesReduced();
  }

 private:
  Ranks& ranks_;
};

/// What every rank but the first does: traces what rank 0 says, until it says that all is over. Signals are rank 0's.
void serveRank0(Ranks& ranks);

}  // namespace parhelion
