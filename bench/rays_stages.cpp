// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <deque>
#include <span>

#include "csv.h"
#include "math/names.h"
#include "rays_configurations.h"
#include "rays_embree_scene.h"
#include "rays_plan.h"
#include "rays_queries.h"
#include "rays_render.h"
#include "rays_stage_clock.h"
#include "trace/sky_film.h"

namespace parhelion::bench {
namespace {

constexpr int kSide = 1024;         // pixels, of the film
constexpr int kLoopPools = 1 << 8;  // of recorded rays for the bare loops
constexpr int kWaves = 32;          // a round

/// Embree's own calls for rays on their way, asked once more with nothing else in between.
class CallTimer {
 public:
  explicit CallTimer(RTCScene scene) : scene_(scene) {}

  void time(const RayPool& pool) {
    const int packets = (pool.active + kPacket - 1) / kPacket;
    // Lanes that are not valid repeat the last ray, as in EmbreeIntersector.
    for (int i = 0; i < packets * kPacket; ++i)
      put(embreeQuery(pool, std::min(i, pool.active - 1)), i, i < pool.active);
    clock_.start();
    for (int p = 0; p < packets; ++p) intersectClosest(valid_[p].data(), scene_, packets_[p]);
    clock_.lap(Stage::naming);
  }
  double nanoseconds() const { return clock_.nanoseconds(Stage::naming); }

 private:
  static constexpr int kPacket = 16;  // as EmbreeIntersector has it

  void put(const RTCRayHit& query, int i, bool active) {
    auto& [ray, hit] = packets_[i / kPacket];
    const int k = i % kPacket;
    ray.org_x[k] = query.ray.org_x;
    ray.org_y[k] = query.ray.org_y;
    ray.org_z[k] = query.ray.org_z;
    ray.dir_x[k] = query.ray.dir_x;
    ray.dir_y[k] = query.ray.dir_y;
    ray.dir_z[k] = query.ray.dir_z;
    ray.tfar[k] = query.ray.tfar;
    ray.mask[k] = query.ray.mask;
    hit.geomID[k] = hit.instID[0][k] = RTC_INVALID_GEOMETRY_ID;
    valid_[i / kPacket][k] = active ? -1 : 0;
  }

  RTCScene scene_;
  std::array<RTCRayHit16, RayPool::kRoom / kPacket> packets_{};
  alignas(64) std::array<std::array<int, kPacket>, RayPool::kRoom / kPacket> valid_;
  StageClock clock_;
};

CallTimer* callTimer = nullptr;  // of the wave under way

/// The bare loop that an engine's search for faces is held against.
class BareLoop {
 public:
  BareLoop(const Cloud& cloud, Engine engine, const LaneSteps& steps, RTCScene scene)
      : engines_(makeIntersectors(cloud, engine)), steps_(steps), scene_(scene), pools_(kLoopPools) {
    const std::vector<InteriorRay> rays = interiorRays(cloud, kLoopPools * RayPool::kRoom);
    for (int p = 0; p < kLoopPools; ++p) {
      fillPool(pools_[p], std::span(rays).subspan(p * RayPool::kRoom, RayPool::kRoom), onlyCrystal(cloud).stretch);
      for (int i = 0; i < RayPool::kRoom; ++i) queries_.push_back(embreeQuery(pools_[p], i));
    }
  }

  void run() {
    const Stopwatch watch;
    const auto* planes = std::get_if<PlanesIntersector>(&engines_.front());
    found_ += planes ? askPlanes(planes->slabs()) : askEmbree();
    seconds_ += watch.read().seconds;
  }

  double perSecond() const { return static_cast<double>(found_) / seconds_; }

 private:
  std::uint64_t askEmbree() {
    unsigned sum = 0;
    for (RTCRayHit query : queries_) {
      intersectClosest(scene_, query);
      sum += query.hit.geomID;
    }
    sum_ = sum;
    return queries_.size();
  }

  /// Each pool many times, since a wave's only one is in the first cache.
  std::uint64_t askPlanes(const SlabTable& slabs) {
    constexpr int kRepeats = 16;
    for (RayPool& pool : pools_)
      for (int i = 0; i < kRepeats; ++i) steps_.findFaces(slabs, pool);
    return kRepeats * queries_.size();
  }

  Intersectors engines_;
  const LaneSteps& steps_;
  RTCScene scene_;
  std::vector<RayPool> pools_;
  std::vector<RTCRayHit> queries_;
  volatile unsigned sum_ = 0;  // keeps the loop from being left out
  double seconds_ = 0.0;
  std::uint64_t found_ = 0;
};

/// Wave after wave of one engine and one set of registers: as they are, on the stage clock, with Embree's calls timed.
class Runner {
 public:
  Runner(const Cloud& cloud, Engine engine, Simd simd, Film& film)
      : engine_(engine),
        simd_(simd),
        real_(laneSteps(simd)),
        timed_(timedSteps(real_)),
        bundles_(Wave::bundles(cloud)),
        engines_(makeIntersectors(cloud, engine)),
        paths_(cloud, {}),
        plainWave_(cloud, engines_, paths_, tracing(engine), real_),
        timedWave_(cloud, engines_, paths_, tracing(engine), timed_),
        scene_(*onlyCrystal(cloud).mesh, {}),
        calls_(scene_.get()),
        film_(film),
        timedFilm_(film),
        loop_(cloud, engine, real_, scene_.get()) {}

  void round() {
    const Stopwatch watch;
    trace(plainWave_, film_);
    seconds_ += watch.read().seconds;
    runTimed(clock_, false);
    if (engine_ == Engine::embree) runTimed(spare_, true);
    loop_.run();
    ++rounds_;
  }

  Engine engine() const { return engine_; }
  Simd simd() const { return simd_; }
  const TraceCounts& counts() const { return plainWave_.counts(); }
  double seconds() const { return seconds_; }
  double loopPerSecond() const { return loop_.perSecond(); }
  double perRay(double nanoseconds) const { return nanoseconds / static_cast<double>(counts().rays); }
  double perRay(Stage stage) const { return perRay(clock_.nanoseconds(stage)); }
  double callsPerRay() const { return perRay(calls_.nanoseconds()); }

 private:
  void trace(Wave& wave, Film& tally) {
    for (int i = 0; i < kWaves; ++i) {
      const std::uint64_t first = static_cast<std::uint64_t>(rounds_ * kWaves + i) * bundles_;
      wave.trace(first, bundles_, 1, tally);
    }
  }

  void runTimed(StageClock& clock, bool withCalls) {
    callTimer = &calls_;
    stageWatch = {&real_, &clock, nullptr};
    if (withCalls) stageWatch.onNamed = [](const RayPool& pool) { callTimer->time(pool); };
    clock.start();
    trace(timedWave_, timedFilm_);
  }

  const Engine engine_;
  const Simd simd_;
  const LaneSteps& real_;
  LaneSteps timed_;
  int bundles_;
  Intersectors engines_;
  PathPlan paths_;  // that keep nothing
  Wave plainWave_, timedWave_;
  EmbreeScene scene_;
  CallTimer calls_;
  Film& film_;
  TimedTally timedFilm_;
  StageClock clock_, spare_;
  double seconds_ = 0.0;
  int rounds_ = 0;
  BareLoop loop_;
};

}  // namespace

void measureStages(const RaysPlan& plan) {
  const Cloud cloud = randomPrisms(1.0);
  Tally tally = wholeSky(cloud, kSide);
  SkyFilm film({&tally}, nullptr);
  std::deque<Runner> runners;
  for (const Simd simd : simdHere())
    for (const Engine engine : {Engine::embree, Engine::planes}) runners.emplace_back(cloud, engine, simd, film);
  // Round after round, so that other programs disturb all alike.
  const Stopwatch watch;
  while (watch.read().seconds < (plan.quick ? 2.5 : 15.0))
    for (Runner& runner : runners) runner.round();

  Csv csv(plan.results / "rays_stages.csv",
          "Hexagonal prisms of aspect 1 in random orientation, 550 nm, point sun 20 degrees high, seed 1, 1024 x 1024 "
          "pixels of whole sky, one thread.\n"
          "Stages in nanoseconds a ray, without the clock's own cost; whole: the same without the clock. embree_calls: "
          "Embree's own; intersection: all else that finds the next face.\n"
          "loop_per_second: next faces of a bare loop over recorded interior rays, in the same run.",
          "engine,registers,rays,hits,start,entry,embree_calls,intersection,optics,deposit,pool,whole,clock_cost,"
          "hits_per_second,interior_per_second,loop_per_second");
  double pool = 0.0;
  for (auto runner = runners.rbegin(); runner != runners.rend(); ++runner) {
    const Runner& r = *runner;
    const bool embree = r.engine() == Engine::embree;
    // Both engines refill the pool alike; where Embree is asked the clock cannot tell.
    if (!embree) pool = r.perRay(Stage::pool);
    const double calls = embree ? r.callsPerRay() : 0.0;
    const double naming = r.perRay(Stage::naming) + r.perRay(Stage::pool) - pool;
    const double hits = static_cast<double>(r.counts().hits), rays = static_cast<double>(r.counts().rays);
    csv.row(nameOf(r.engine()), nameOf(r.simd()), r.counts().rays, r.counts().hits, r.perRay(Stage::start),
            r.perRay(Stage::entry), calls, naming - calls + r.perRay(Stage::intersection), r.perRay(Stage::optics),
            r.perRay(Stage::deposit), pool, r.perRay(1e9 * r.seconds()), StageClock::ownCost(), hits / r.seconds(),
            (hits - rays) / r.seconds(), r.loopPerSecond());
  }
}

}  // namespace parhelion::bench
