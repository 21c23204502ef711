// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <tbb/task_arena.h>

#include "csv.h"
#include "math/names.h"
#include "rays_configurations.h"
#include "rays_deposits.h"
#include "rays_memory.h"
#include "rays_plan.h"
#include "rays_queries.h"
#include "rays_render.h"

namespace parhelion::bench {
namespace {

constexpr double kAspect = 2.0;
constexpr int kRepeats = 3;
constexpr int kSide = 1024;              // pixels, where the number of threads varies
constexpr std::size_t kPixelBytes = 32;  // of a tally of luminance alone
constexpr Engine kEngines[] = {Engine::embree, Engine::planes};
const std::string kScene =
    "Hexagonal columns of aspect 2 in random orientation, 550 nm, point sun, seed 1, whole sky.\n";

std::vector<int> sides(const RaysPlan& plan) {
  if (plan.quick) return {512, 1024, 2048};
  return {512, 1024, 2048, 4096, 8192};
}

int processors() { return tbb::this_task_arena::max_concurrency(); }

/// 1, 2, 3, 4, 6, 9, ... up to twice the processors.
std::vector<int> threadCounts() {
  std::vector<int> counts;
  for (int n = 1; n <= 2 * processors(); n += std::max(1, n / 2)) counts.push_back(n);
  return counts;
}

/// The fastest of three renders: the one that other programs disturbed least.
RenderSpeed fastestRender(const RaysPlan& plan, const Cloud& cloud, Engine engine, int side, int threads) {
  RenderSpeed best;
  for (int i = 0; i < kRepeats; ++i) {
    const RenderSpeed again = renderFor(plan.seconds() / kRepeats, cloud, tracing(engine), side, threads);
    if (i == 0 || again.perSecond() > best.perSecond()) best = again;
  }
  return best;
}

void renderByThreads(const RaysPlan& plan) {
  Csv csv(plan.results / "rays_scaling_threads.csv", kScene + "Films of 1024 x 1024 pixels.",
          "engine,threads,side,rays,seconds,rays_per_second,rays_per_cpu_second");
  const Cloud cloud = randomPrisms(kAspect);
  for (const Engine engine : kEngines)
    for (const int threads : threadCounts()) {
      const RenderSpeed render = fastestRender(plan, cloud, engine, kSide, threads);
      csv.row(nameOf(engine), threads, kSide, render.rays, render.timing.seconds, render.perSecond(),
              render.perCpuSecond(render.rays));
    }
}

void renderBySize(const RaysPlan& plan) {
  Csv csv(plan.results / "rays_scaling_sizes.csv",
          kScene +
              "One thread a processor. peak_memory: the most that the whole process held, its mark set back before "
              "each render by\n"
              "/proc/self/clear_refs.",
          "engine,side,threads,rays,seconds,rays_per_second,peak_memory");
  const Cloud cloud = randomPrisms(kAspect);
  for (const Engine engine : kEngines)
    for (const int side : sides(plan)) {
      resetPeakMemory();
      const RenderSpeed render = fastestRender(plan, cloud, engine, side, processors());
      csv.row(nameOf(engine), side, processors(), render.rays, render.timing.seconds, render.perSecond(), peakMemory());
    }
}

/// The fastest of three; of the largest tallies, which take long to make, one.
DepositSpeed fastestDeposits(Sharing sharing, const std::vector<PixelDeposit>& deposits, int side, int threads) {
  constexpr int kPasses = 2, kLarge = 8192;
  DepositSpeed best = depositBy(sharing, deposits, kPasses, side, threads);
  for (int i = 1; i < kRepeats && side < kLarge; ++i) {
    const DepositSpeed again = depositBy(sharing, deposits, kPasses, side, threads);
    if (again.runPerSecond() > best.runPerSecond()) best = again;
  }
  return best;
}

void depositBySharing(const RaysPlan& plan) {
  Csv csv(plan.results / "rays_scaling_tallies.csv",
          kScene +
              "The same recorded deposits, added again and again by each way in which threads may share a tally.\n"
              "fixed_seconds: making the tallies and merging them. memory: peak above what was held before.\n"
              "run_per_second: deposits a second of a run of 100 million, fixed_seconds included.",
          "sharing,label,side,threads,deposits,deposits_per_second,fixed_seconds,run_per_second,memory");
  const std::vector<SkyDeposit> sky = skyDeposits(randomPrisms(kAspect), plan.quick ? 200'000 : 2'000'000);
  for (const int side : sides(plan)) {
    const std::vector<PixelDeposit> deposits = throughCamera(sky, side);
    for (const int threads : side == kSide ? threadCounts() : std::vector<int>{processors()})
      for (const SharingName& way : kSharings) {
        const std::size_t bytes = kPixelBytes * side * side * static_cast<std::size_t>(talliesOf(way.sharing, threads));
        if (bytes > freeMemory() / 2) continue;
        const DepositSpeed speed = fastestDeposits(way.sharing, deposits, side, threads);
        csv.row(way.id, way.label, side, threads, speed.deposits, speed.perSecond(), speed.fixedSeconds,
                speed.runPerSecond(), speed.memory);
      }
  }
}

}  // namespace

void measureScaling(const RaysPlan& plan) {
  renderByThreads(plan);
  renderBySize(plan);
  depositBySharing(plan);
}

}  // namespace parhelion::bench
