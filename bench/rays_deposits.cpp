// SPDX-License-Identifier: Apache-2.0
#include "rays_deposits.h"

#include <span>
#include <thread>

#include "rays_memory.h"
#include "sky/camera.h"
#include "sky/deposit_buffer.h"
#include "stopwatch.h"
#include "trace/light_path.h"

namespace parhelion::bench {
namespace {

Tally tallyOf(int side, std::uint64_t number) {
  TallyInfo info;
  info.camera.width = info.camera.height = side;
  info.rays = {{number, 1}};  // merging wants different rays
  return Tally(info, 1);
}

/// One thread's work.
void deposit(Sharing sharing, std::span<const PixelDeposit> deposits, int passes, Tally& tally,
             const std::shared_ptr<DepositBuffer::Locks>& locks) {
  const auto addAll = [&](auto&& add) {
    for (int pass = 0; pass < passes; ++pass)
      for (const PixelDeposit& d : deposits) add(d.pixel, Vec3(0.0, d.luminance, 0.0), d.firstHalf);
  };
  switch (sharing) {
    case Sharing::bands: {
      DepositBuffer buffer(tally, locks);
      std::uint64_t bundle = 0;  // of the half that is asked for
      addAll([&](int pixel, const Vec3& xyz, bool half) {
        bundle += (bundle % 2 == 0) == half ? 2 : 1;
        buffer.add(pixel, toFixedLight(xyz, tally.perWhite()), bundle);
      });
      return buffer.flush();
    }
    case Sharing::atomics:
      return addAll([&](int pixel, const Vec3& xyz, bool half) { tally.add(pixel, xyz, half); });
    case Sharing::privateTallies:
      return addAll([&](int pixel, const Vec3& xyz, bool half) { tally.addExclusively(pixel, xyz, half); });
  }
}

}  // namespace

std::vector<SkyDeposit> skyDeposits(const Cloud& cloud, int count) {
  const TraceSettings settings;
  const Intersectors engines = makeIntersectors(cloud, settings.engine);
  std::vector<SkyDeposit> all;
  all.reserve(static_cast<std::size_t>(count));
  RaySource source(cloud, settings, 256);
  LightPath path;
  for (std::uint64_t index = 0;; ++index) {
    followRay(source, engines, settings, index, path);
    for (const Exit& exit : path.exits) {
      if (exit.undeviated) continue;
      all.push_back({-exit.lightDirWorld, exit.energy * path.incident.light.xyz.y, index % 2 == 0});
      if (static_cast<int>(all.size()) == count) return all;
    }
  }
}

std::vector<PixelDeposit> throughCamera(const std::vector<SkyDeposit>& deposits, int side) {
  CameraSettings settings;
  settings.width = settings.height = side;
  const Camera camera(settings);
  std::vector<PixelDeposit> seen;
  seen.reserve(deposits.size());
  for (const SkyDeposit& d : deposits)
    if (const auto pixel = camera.pixelAt(d.toSky)) seen.push_back({d.luminance, *pixel, d.firstHalf});
  return seen;
}

DepositSpeed depositBy(Sharing sharing, const std::vector<PixelDeposit>& deposits, int passes, int side, int threads) {
  resetPeakMemory();
  const std::size_t before = peakMemory();
  const Stopwatch whole;
  std::vector<Tally> tallies;
  tallies.reserve(static_cast<std::size_t>(threads));
  for (int t = 0; t < talliesOf(sharing, threads); ++t) tallies.push_back(tallyOf(side, static_cast<std::uint64_t>(t)));
  const auto locks = std::make_shared<DepositBuffer::Locks>();

  const Stopwatch watch;
  {
    std::vector<std::jthread> workers;
    for (int t = 0; t < threads; ++t) {
      const std::size_t n = deposits.size(), from = n * t / threads, to = n * (t + 1) / threads;
      Tally& tally = tallies[sharing == Sharing::privateTallies ? t : 0];
      workers.emplace_back([&, from, to, own = &tally] {
        deposit(sharing, std::span(deposits).subspan(from, to - from), passes, *own, locks);
      });
    }
  }
  DepositSpeed speed{deposits.size() * static_cast<std::size_t>(passes), watch.read().seconds};
  for (std::size_t t = 1; t < tallies.size(); ++t) tallies[0].merge(tallies[t]);
  speed.fixedSeconds = whole.read().seconds - speed.seconds;
  speed.memory = peakMemory() - before;
  return speed;
}

}  // namespace parhelion::bench
