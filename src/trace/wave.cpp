// SPDX-License-Identifier: Apache-2.0
#include "trace/wave.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace parhelion {

namespace {

/// A pool of rays that carry no light, whose numbers harm nobody.
std::unique_ptr<RayPool> emptyPool() {
  auto pool = std::make_unique<RayPool>();
  for (RayPool::Numbers* row : {&pool->iceIndex, &pool->perIceIndex, &pool->splitAbove, &pool->stretch}) row->fill(1.0);
  return pool;
}

/// The units of EnergyUnits for rays that weigh at most so much: those of ExactSum, or coarser by a power of two. They
/// depend on the population alone, so that sums do not on who traces what.
double unitsPerLight(double highestWeight) {
  constexpr double kMost = 0x1p51;  // of a ray
  double perLight = ExactSum::kScale;
  while (perLight > 1.0 && highestWeight * perLight >= kMost) perLight *= 0.5;
  return perLight;
}

}  // namespace

void TraceCounts::merge(const TraceCounts& other) {
  rays += other.rays;
  hits += other.hits;
  deposits += other.deposits;
  placed += other.placed;
  rescued += other.rescued;
  energy.merge(other.energy);
}

int Wave::bundles(const Cloud& cloud) {
  constexpr int kRays = 1024;
  if (cloud.hasSpreadShapes()) return cloud.bundlesPerShape();
  return std::max(32, kRays / cloud.bundleSize()) - RayQueue::kSpare;
}

Wave::Wave(const Cloud& cloud, const Intersectors& engines, const PathPlan& paths, const TraceSettings& settings,
           const LaneSteps& steps)
    : cloud_(cloud),
      engines_(engines),
      paths_(paths),
      steps_(steps),
      seed_(settings.seed),
      rule_(pathRule(settings.path)),
      source_(cloud, settings, bundles(cloud), steps),
      ownEngine_(settings.engine),
      own_(cloud.populations().size()),
      pool_(emptyPool()) {
  exits_.record = paths.record();
  for (int p = 0; p < static_cast<int>(cloud.populations().size()); ++p)
    perLight_.push_back(unitsPerLight(cloud.incidence(p, settings.sampler).highestWeight()));
}

void Wave::trace(std::uint64_t first, int count, int members, Film& tally) {
  if (!cloud_.hasSpreadShapes()) return traceBlock(first, count, members, tally);
  const auto block = static_cast<std::uint64_t>(cloud_.bundlesPerShape());
  for (std::uint64_t at = first; at < first + count;) {
    const std::uint64_t some = std::min(first + count - at, block - at % block);
    traceBlock(at, static_cast<int>(some), members, tally);
    at += some;
  }
}

/// The same for bundles that meet the same crystals where shapes are spread.
void Wave::traceBlock(std::uint64_t first, int count, int members, Film& tally) {
  source_.draw(first, count);
  for (int p = 0; p < static_cast<int>(engines_.size()); ++p) {
    RayQueue& queue = source_.queues()[p];
    if (queue.count == 0) continue;
    follow(queue, p, members);
    counts_.placed += tally.add({queue, exits_, members, p, source_.mesh(p), steps_});
  }
}

void Wave::follow(RayQueue& queue, int population, int members) {
  if (const ConcaveCrystal* concave = cloud_.concave(population))
    return followConcave(*concave, queue, population, members);
  const FaceTable& faces = source_.faces(population);
  const PathTable paths = paths_.table(population);
  const CrystalOptics& optics = cloud_.optics(population);
  isIdeal_ = optics.isIdeal();
  const auto enter = steps_.enter.of(paths_.record(), optics);
  const auto meetFaces = steps_.meetFaces.of(paths_.record(), optics);
  exits_.count = 0;
  // Places not taken are worked on, too, and another population's automaton may have more states.
  pool_->pathState.fill(PathAutomaton::kStart);
  energy_ = {.perLight = perLight_[population]};
  for (int member = 0; member < members; ++member) {
    exits_.reserve(queue.count + RayQueue::kSpare);
    enter(faces, optics, paths, seed_, rule_, member, queue, exits_, energy_);
  }
  counts_.hits += static_cast<std::uint64_t>(members) * queue.count;

  nextMember_ = nextPlace_ = 0;
  while (pool_->active < RayPool::kRoom && putNext(queue, population, members, pool_->active)) ++pool_->active;
  while (pool_->active > 0) {
    exits_.reserve(RayPool::kRoom + RayQueue::kSpare);
    findFaces(population);
    meetFaces(faces, optics, paths, *pool_, exits_, energy_);
    counts_.hits += pool_->active;
    refill(queue, population, members);
  }
  finish(queue, population, members);
}

void Wave::followConcave(const ConcaveCrystal& crystal, RayQueue& queue, int population, int members) {
  exits_.count = 0;
  energy_ = {.perLight = perLight_[population]};
  const ConcavePaths::Counts counts = concavePaths_.follow(crystal, cloud_.optics(population), paths_, population,
                                                           seed_, rule_, members, queue, exits_, energy_);
  counts_.hits += counts.hits;
  counts_.rescued += counts.rescued;
  for (int member = 0; member < members; ++member)
    for (int place = 0; place < queue.count; ++place)
      if (const double cutOff = queue.cutOff[queue.ray(member, place)]; cutOff > 0.0) counts_.energy.cutOff.add(cutOff);
  counts_.energy.absorbed.merge(counts.absorbed);
  finish(queue, population, members);
}

/// Counts what has become of the rays and sorts the exits.
void Wave::finish(RayQueue& queue, int population, int members) {
  count(queue, members);
  if (paths_.hasFilter()) filter(population);
  steps_.turnToWorld(queue, exits_);
  if (paths_.layers() > 0) sortByLayer(queue, population);
}

void Wave::findFaces(int population) {
  const MeshTables tables{source_.mesh(population), source_.faces(population)};
  counts_.rescued +=
      std::visit([&](const auto& engine) { return engine.findFaces(tables, steps_, *pool_); }, engine(population));
}

const Intersector& Wave::engine(int population) {
  const auto block = source_.blockOf(population);
  if (!block) return engines_[population];
  auto& own = own_[population];
  if (!own || own->block != *block)
    own.emplace(OwnEngine{*block, makeIntersector(ownEngine_, source_.mesh(population), devices_)});
  return own->engine;
}

/// Puts the queue's next ray that has light inside its crystal at a place of the pool; false when there is none.
bool Wave::putNext(RayQueue& queue, int population, int members, int place) {
  for (; nextMember_ < members; ++nextMember_, nextPlace_ = 0)
    while (nextPlace_ < queue.count) {
      const int from = nextPlace_++, ray = queue.ray(nextMember_, from);
      queue.internalPath[ray] = queue.lost[ray] = queue.cutOff[ray] = 0.0;
      if (!isIdeal_) queue.absorbed[ray] = 0.0;
      if (queue.energy[ray] <= 0.0) continue;
      RayPool& pool = *pool_;
      for (int k = 0; k < 3; ++k) {
        pool.point[k][place] = queue.point[k][from];
        pool.lightDir[k][place] = queue.inside[k][ray];
      }
      pool.energy[place] = queue.energy[ray];
      pool.face[place] = queue.face[from];
      pool.order[place] = pool.internalPath[place] = pool.lost[place] = 0.0;
      pool.random0[place] = queue.random0[from];
      pool.random1[place] = queue.random1[from];
      pool.ray[place] = ray;
      pool.stretch[place] = queue.stretch[from];
      pool.iceIndex[place] = queue.iceIndex[ray];
      pool.perIceIndex[place] = 1.0 / queue.iceIndex[ray];
      pool.splitAbove[place] = queue.weight[from] * rule_.splitShare;
      if (!isIdeal_) {
        pool.absorption[place] = queue.absorption[ray];
        pool.wave[place] = queue.wave[ray];
        pool.absorbed[place] = 0.0;
      }
      if (paths_.record() != PathRecord::nothing) beginPath(population, place);
      return true;
    }
  return false;
}

/// The ray at a place of the pool has met the face of its entry.
void Wave::beginPath(int population, int place) {
  const int face = static_cast<int>(pool_->face[place]);
  pool_->pathState[place] = paths_.automaton(population).next(PathAutomaton::kStart, face);
  if (paths_.record() != PathRecord::sequence) return;
  const PathCode::Words words = paths_.code(population).with({}, face, 0);
  pool_->pathFirst[place] = words.first;
  pool_->pathLast[place] = words.last;
}

/// Gives the places of rays that have ended to the next ones, or to the last of the pool.
void Wave::refill(RayQueue& queue, int population, int members) {
  // From the back, so that the last ray of the pool is never one that has ended.
  for (int k = pool_->endedCount - 1; k >= 0; --k) {
    const int place = static_cast<int>(pool_->ended[k]);
    settle(queue, place);
    if (putNext(queue, population, members, place)) continue;
    const int last = --pool_->active;
    if (place == last) continue;
    pool_->move(last, place);
    if (paths_.record() != PathRecord::nothing) pool_->movePath(last, place);
    if (!isIdeal_) pool_->moveOptics(last, place);
    pool_->energy[last] = 0.0;
  }
}

/// Writes down what became of a ray that has ended.
void Wave::settle(RayQueue& queue, int place) {
  const int ray = static_cast<int>(pool_->ray[place]);
  queue.internalPath[ray] = pool_->internalPath[place];
  queue.lost[ray] = pool_->lost[place];
  if (!isIdeal_) {
    queue.absorbed[ray] = pool_->absorbed[place];
    counts_.energy.absorbed.add(queue.absorbed[ray]);
  }
  const double left = std::exchange(pool_->energy[place], 0.0);
  queue.cutOff[ray] = left;
  if (left > 0.0) counts_.energy.cutOff.add(left);
}

/// Takes off the list what the filter does not keep.
void Wave::filter(int population) {
  int kept = 0;
  std::int64_t filtered = 0;
  for (int i = 0; i < exits_.count; ++i) {
    if (paths_.keeps(population, exits_.pathState[i]))
      exits_.move(i, kept++);
    else
      filtered += std::llrint(exits_.energy[i] * energy_.perLight);  // as LaneSteps::enter and meetFaces count it
  }
  counts_.deposits -= static_cast<std::uint64_t>(exits_.count - kept);
  exits_.count = kept;
  const auto units = coarserUnits() * ExactSum::Units{filtered};
  counts_.energy.filtered.addUnits(units);
  counts_.energy.out.addUnits(-units);
}

/// Says of each exit which layer its light belongs to.
void Wave::sortByLayer(const RayQueue& queue, int population) {
  exits_.layer.resize(static_cast<std::size_t>(exits_.count));
  if (!paths_.hasTilts(population)) {
    const int* ofState = paths_.layersOf(population).data();
    const double* state = exits_.pathState.data();
    std::transform(state, state + exits_.count, exits_.layer.begin(),
                   [ofState](double s) { return ofState[static_cast<int>(s)]; });
    return;
  }
  allowed_.resize(static_cast<std::size_t>(queue.count));
  for (int place = 0; place < queue.count; ++place) {
    const auto axis = [place](const RayQueue::Row* rows) {
      return Vec3(rows[0][place], rows[1][place], rows[2][place]);
    };
    allowed_[static_cast<std::size_t>(place)] =
        paths_.layersFor(population, axis(queue.crystalY), axis(queue.crystalZ));
  }
  for (int i = 0; i < exits_.count; ++i) {
    const int place = queue.placeOf(static_cast<int>(exits_.ray[i]));
    exits_.layer[static_cast<std::size_t>(i)] =
        paths_.layerOf(population, exits_.pathState[i], allowed_[static_cast<std::size_t>(place)]);
  }
}

void Wave::count(const RayQueue& queue, int members) {
  counts_.rays += static_cast<std::uint64_t>(members) * queue.count;
  counts_.deposits += exits_.count;
  counts_.hits -= energy_.lostPaths;
  for (int place = 0; place < queue.count; ++place) counts_.energy.in.add(members * queue.weight[place]);
  counts_.energy.out.addUnits(coarserUnits() * energy_.out);
  counts_.energy.lost.addUnits(coarserUnits() * energy_.lost);
}

void TraceCounts::visitSums(SumVisitor& visitor) {
  for (std::uint64_t* count : {&rays, &hits, &deposits, &placed, &rescued}) visitor.visit(*count);
  for (ExactSum* sum : {&energy.in, &energy.out, &energy.filtered, &energy.absorbed, &energy.cutOff, &energy.lost})
    visitor.visit(*sum);
}

}  // namespace parhelion
