// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <deque>
#include <numeric>
#include <span>

#include "csv.h"
#include "rays_embree_scene.h"
#include "rays_finders.h"
#include "rays_plan.h"
#include "stopwatch.h"

namespace parhelion::bench {
namespace {

constexpr int kTimedPools = 1 << 8;  // of a pass that is timed
constexpr double kAspects[] = {0.1, 1.0, 10.0};

// A packet as each generation of Embree wants it asked.
#if RTC_VERSION_MAJOR >= 4
#define PARHELION_PACKET(rays)                                                            \
  inline void intersectPacket(const int* valid, RTCScene scene, RTCRayHit##rays& query) { \
    rtcIntersect##rays(valid, scene, &query);                                             \
  }
#else
#define PARHELION_PACKET(rays)                                                            \
  inline void intersectPacket(const int* valid, RTCScene scene, RTCRayHit##rays& query) { \
    RTCIntersectContext context;                                                          \
    rtcInitIntersectContext(&context);                                                    \
    rtcIntersect##rays(valid, scene, &context, &query);                                   \
  }
#endif
PARHELION_PACKET(4)
PARHELION_PACKET(8)
PARHELION_PACKET(16)
#undef PARHELION_PACKET

/// What is asked of Embree for the rays of a pool; the answers go to its nextFace.
struct Asked {
  const Crystal& crystal;
  const EmbreeScene& scene;
  bool masked;  // the face left is out of sight
  float from;   // distance at which hits begin, crystal units

  void one(RayPool& pool, int i) const {
    RTCRayHit query = embreeQuery(pool, i);
    if (!masked) query.ray.mask = ~0u;
    query.ray.tnear = from;
    intersectClosest(scene.get(), query);
    pool.nextFace[i] = scene.face(query.hit.geomID, query.hit.primID);
  }
};

void oneByOne(const Asked& asked, RayPool& pool) {
  for (int i = 0; i < pool.active; ++i) asked.one(pool, i);
}

/// A row of a packet from one of the pool.
template <int kRays>
void fillRow(float* to, const double* from, double scale) {
  for (int k = 0; k < kRays; ++k) to[k] = static_cast<float>(from[k] * scale);
}

/// The pool is full.
template <class Packet, int kRays>
void inPackets(const Asked& asked, RayPool& pool) {
  alignas(64) int valid[kRays];
  std::fill_n(valid, kRays, -1);
  alignas(64) Packet packet{};
  auto& [ray, hit] = packet;
  for (int i = 0; i < pool.active; i += kRays) {
    fillRow<kRays>(ray.org_x, &pool.point[0][i], 1.0);
    fillRow<kRays>(ray.org_y, &pool.point[1][i], 1.0);
    fillRow<kRays>(ray.org_z, &pool.point[2][i], 1.0 / asked.crystal.stretch);
    fillRow<kRays>(ray.dir_x, &pool.lightDir[0][i], 1.0);
    fillRow<kRays>(ray.dir_y, &pool.lightDir[1][i], 1.0);
    fillRow<kRays>(ray.dir_z, &pool.lightDir[2][i], 1.0 / asked.crystal.stretch);
    for (int k = 0; k < kRays; ++k) {
      ray.tnear[k] = asked.from;
      ray.tfar[k] = std::numeric_limits<float>::infinity();
      ray.mask[k] = asked.masked ? maskWithout(static_cast<int>(pool.face[i + k])) : ~0u;
      hit.geomID[k] = hit.instID[0][k] = RTC_INVALID_GEOMETRY_ID;
    }
    intersectPacket(valid, asked.scene.get(), packet);
    for (int k = 0; k < kRays; ++k) pool.nextFace[i + k] = asked.scene.face(hit.geomID[k], hit.primID[k]);
  }
}

int octant(const RayPool& pool, int i) {
  return (pool.lightDir[0][i] < 0.0) + 2 * (pool.lightDir[1][i] < 0.0) + 4 * (pool.lightDir[2][i] < 0.0);
}
int faceLeft(const RayPool& pool, int i) { return static_cast<int>(pool.face[i]); }

/// Rays with the same key one behind the other; the sorting is part of the work.
template <int (*kKey)(const RayPool&, int)>
void sorted(const Asked& asked, RayPool& pool) {
  int behind[kMaxFaces + 1]{};
  std::array<int, RayPool::kRoom> order;
  for (int i = 0; i < pool.active; ++i) ++behind[kKey(pool, i) + 1];
  std::partial_sum(std::begin(behind), std::end(behind), behind);
  for (int i = 0; i < pool.active; ++i) order[behind[kKey(pool, i)]++] = i;
  for (int i = 0; i < pool.active; ++i) asked.one(pool, order[i]);
}

/// The planes decide where Embree finds no face or that which the ray starts on.
template <void (*kAsk)(const Asked&, RayPool&)>
void rescued(const Asked& asked, RayPool& pool) {
  kAsk(asked, pool);
  for (int i = 0; i < pool.active; ++i) {
    if (pool.nextFace[i] != kNoFace && pool.nextFace[i] != pool.face[i]) continue;
    const auto at = [i](const RayPool::Numbers* rows) { return Vec3(rows[0][i], rows[1][i], rows[2][i]); };
    const auto hit = nextFaceByPlanes(asked.crystal, at(pool.point), at(pool.lightDir), static_cast<int>(pool.face[i]));
    pool.nextFace[i] = hit ? hit->face : kNoFace;
  }
}

/// A way to ask Embree for the next face.
struct Way {
  const char *id, *label;
  void (*ask)(const Asked&, RayPool&);
  EmbreeSceneSettings scene;
  bool masked = true;
  float from = 0.0f;
};

/// The first is that of EmbreeIntersector; the others differ from the second as their labels say.
const Way kWays[] = {
    {"packets16", "in use: packets of 16", inPackets<RTCRayHit16, 16>, {}},
    {"masks", "single rays with quads and masks", oneByOne, {}},
    {"triangles", "triangles", oneByOne, {.triangles = true}},
    {"robust", "robust", oneByOne, {.flags = RTC_SCENE_FLAG_ROBUST}},
    {"medium", "medium build quality", oneByOne, {.quality = RTC_BUILD_QUALITY_MEDIUM}},
    {"low", "low build quality", oneByOne, {.quality = RTC_BUILD_QUALITY_LOW}},
    {"packets4", "packets of 4", inPackets<RTCRayHit4, 4>, {}},
    {"packets8", "packets of 8", inPackets<RTCRayHit8, 8>, {}},
    {"octants", "sorted by octant", sorted<octant>, {}},
    {"faces", "sorted by face left", sorted<faceLeft>, {}},
    {"filter", "filter instead of masks", oneByOne, {.together = true, .filtered = true}, false},
    {"from1e-6", "hits from 1e-6 on instead", oneByOne, {.together = true}, false, 1e-6f},
    {"from1e-5", "hits from 1e-5 on instead", oneByOne, {.together = true}, false, 1e-5f},
    {"from1e-4", "hits from 1e-4 on instead", oneByOne, {.together = true}, false, 1e-4f},
    {"from1e-3", "hits from 1e-3 on instead", oneByOne, {.together = true}, false, 1e-3f},
    {"rescued", "from 1e-5 on; planes help", rescued<oneByOne>, {.together = true}, false, 1e-5f},
    {"rescued4", "the same in packets of 4", rescued<inPackets<RTCRayHit4, 4>>, {.together = true}, false, 1e-5f},
    {"rescued8", "the same in packets of 8", rescued<inPackets<RTCRayHit8, 8>>, {.together = true}, false, 1e-5f},
    {"rescued16", "the same in packets of 16", rescued<inPackets<RTCRayHit16, 16>>, {.together = true}, false, 1e-5f},
};

/// One of the ways in one crystal.
class Contender {
 public:
  Contender(const Way& way, const Crystal& crystal) : way_(way), crystal_(crystal), scene_(*crystal.mesh, way.scene) {}

  void ask(RayPool& pool) const { way_.ask({crystal_, scene_, way_.masked, way_.from}, pool); }

  void countErrors(RayPool& pool, const std::vector<int>& exact) {
    ask(pool);
    for (int i = 0; i < pool.active; ++i) {
      if (pool.nextFace[i] == exact[i]) continue;
      ++(pool.nextFace[i] == kNoFace ? lost_ : pool.nextFace[i] == pool.face[i] ? self_ : wrong_);
    }
  }

  void time(std::vector<RayPool>& pools) {
    const Stopwatch watch;
    for (RayPool& pool : pools) ask(pool);
    seconds_ = std::min(seconds_, watch.read().seconds);
  }

  void write(Csv& csv, double aspect, std::size_t queries) const {
    const double errors = static_cast<double>(wrong_ + self_ + lost_);
    csv.row(way_.id, way_.label, aspect, queries, wrong_, self_, lost_, 1e6 * errors / static_cast<double>(queries),
            1e-6 * kTimedPools * RayPool::kRoom / seconds_);
  }

 private:
  const Way& way_;
  const Crystal& crystal_;
  EmbreeScene scene_;
  std::uint64_t wrong_ = 0, self_ = 0, lost_ = 0;
  double seconds_ = std::numeric_limits<double>::infinity();  // the fastest pass over the timed pools
};

void measureIn(double aspect, int pools, int rounds, Csv& csv) {
  const Cloud cloud = randomPrisms(aspect);
  const Crystal crystal = onlyCrystal(cloud);
  std::deque<Contender> contenders;
  for (const Way& way : kWays) contenders.emplace_back(way, crystal);

  const std::vector<InteriorRay> rays = interiorRays(cloud, static_cast<std::size_t>(pools) * RayPool::kRoom);
  std::vector<RayPool> timed(kTimedPools);
  std::vector<int> exact(RayPool::kRoom);
  for (int p = 0; p < pools; ++p) {
    const auto some = std::span(rays).subspan(static_cast<std::size_t>(p) * RayPool::kRoom, RayPool::kRoom);
    RayPool& pool = timed[p % kTimedPools];
    fillPool(pool, some, crystal.stretch);
    std::ranges::transform(some, exact.begin(), [&](const InteriorRay& ray) {
      return exactNextFace(crystal, ray.point, ray.lightDir, ray.leftFace);
    });
    for (Contender& contender : contenders) contender.countErrors(pool, exact);
  }
  // Round after round, so that other programs disturb all ways alike.
  for (int round = 0; round < rounds; ++round)
    for (Contender& contender : contenders) contender.time(timed);
  for (const Contender& contender : contenders) contender.write(csv, aspect, rays.size());
}

}  // namespace

void measureEmbree(const RaysPlan& plan) {
  Csv csv(
      plan.results / "rays_embree.csv",
      "Hexagonal prisms in random orientation, 550 nm, point sun 20 degrees high, seed 1, one thread.\n"
      "All ways find the next face of the same interior rays of real paths. wrong: where half-spaces in long double "
      "find another face; self: where it is the face the ray starts on; lost: where there is none.\n"
      "million_per_second: next faces in the fastest pass over 32768 of the rays, making the queries included.",
      "way,label,aspect,queries,wrong,self,lost,wrong_per_million,million_per_second");
  for (const double aspect : kAspects) measureIn(aspect, plan.quick ? 1 << 10 : 1 << 13, plan.quick ? 8 : 60, csv);
}

}  // namespace parhelion::bench
