// SPDX-License-Identifier: Apache-2.0
#include "trace/order_walker.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "crystal/entry.h"
#include "math/portable.h"
#include "math/rotation.h"
#include "trace/concave_entry.h"
#include "trace/flight_places.h"

namespace parhelion {

namespace {

// Walks followed at a time: enough for full lanes, and few enough for the second-level cache.
constexpr std::size_t kWalks = 512;
// A walk that weighs less than this, of the light that is scattered at all, ends by chance; near the slab's faces,
// where there are more walks for the same light, of less.
constexpr double kLeastShare = 0.1;
// Crystals after which a walk is given up, and bits for their number.
constexpr int kStepBits = 14, kMostSteps = (1 << kStepBits) - 2;
// Directions that haze scatters to at a time.
constexpr int kHazeExits = 4;
// The least sine of an elevation at which light leaves the slab: what is lower is as bright.
constexpr double kLevel = 1e-3;
// Blocks of random numbers for what happens behind a crystal; those below are for drawing it.
constexpr std::uint32_t kBehind = 1U << 24;

/// Bundles' numbers, all different; even for walks of even number, which make one half of a tally.
std::uint64_t bundleOf(std::uint64_t walk, int step) {
  return walk | static_cast<std::uint64_t>(step) << (64 - kStepBits);
}

}  // namespace

void WalkedLight::merge(const WalkedLight& other) {
  light.merge(other.light);
  for (std::size_t k = 0; k < 3; ++k) xyz[k].merge(other.xyz[k]);
}

void WalkedLight::addTo(TallyInfo& info) const {
  for (int image = 0; image < info.images(); ++image) {
    info.intercepted.merge(light);
    for (std::size_t k = 0; k < 3; ++k) info.interceptedXyz[k].merge(xyz[k]);
  }
}

/// Numbers in (0, 1) for one crystal of a walk.
class WalkNumbers {
 public:
  WalkNumbers(std::uint64_t seed, std::uint64_t bundle, std::uint32_t block)
      : seed_(seed), bundle_(bundle), block_(block) {}

  double next() {
    hasSecond_ = !hasSecond_;
    if (!hasSecond_) return second_;
    const auto words = randomWords<std::uint64_t>(seed_, RandomPurpose::walk, block_++, bundle_);
    second_ = toUnitInterval(words.second);
    return toUnitInterval(words.first);
  }

 private:
  std::uint64_t seed_, bundle_;
  std::uint32_t block_;
  double second_ = 0.0;
  bool hasSecond_ = false;
};

namespace {

/// A crystal that light meets: its axes in the world, and the rest as RayQueue has it.
struct MetCrystal {
  Triple<double> x, y, z, light, point;
  double face, stretch, shadow;
};

/// Where light meets a crystal first that has been drawn in some orientation, for more numbers; none where it is not
/// taken. It is in proportion to its shadow.
bool meetFirst(const Cloud& cloud, const ManyOrders::Kind& kind, WalkNumbers& numbers, MetCrystal& met) {
  const FaceTable& faces = cloud.faces(kind.population);
  const double surface = faces.surfaceAcrossC + faces.surfaceAlongC * met.stretch;
  if (const ConcaveCrystal* concave = cloud.concave(kind.population)) {
    const Vec3 light(met.light.x, met.light.y, met.light.z);
    const LitSide lit(*concave, light);
    if (!(numbers.next() * kind.bound * surface < lit.total())) return false;
    const double u1 = numbers.next(), u2 = numbers.next(), u3 = numbers.next();
    const auto entry = lit.entry(u1, u2, u3);
    if (!entry) return false;
    met.face = entry->face;
    met.point = {entry->point.x, entry->point.y, entry->point.z};
    met.shadow = lit.silhouette(u1, u2);
    return true;
  }
  const Shadows<double> shadows = castShadows(faces, met.stretch, met.light);
  if (!(numbers.next() * kind.bound * surface < shadows.total)) return false;
  met.face = litFace(faces, shadows, numbers.next());
  const double u1 = numbers.next(), u2 = numbers.next();
  met.point = pointOnFace(faces, met.stretch, met.face, u1, u2);
  met.shadow = shadows.total;
  return true;
}

/// A crystal of a kind in the way of light of that direction; none where another one has to be proposed.
std::optional<MetCrystal> proposedCrystal(const Cloud& cloud, const ManyOrders::Kind& kind, const Vec3& direction,
                                          WalkNumbers& numbers) {
  const Population& population = cloud.populations()[static_cast<std::size_t>(kind.population)];
  const double u1 = numbers.next(), u2 = numbers.next(), u3 = numbers.next();
  const auto axes = population.orientationQuantile().at(u1, u2, u3);
  const double stretch = population.stretch() ? population.stretch()->at(numbers.next()) : 1.0;
  const Triple<double> world{direction.x, direction.y, direction.z};
  MetCrystal met{axes.x, axes.y, axes.z,  {dot(axes.x, world), dot(axes.y, world), dot(axes.z, world)},
                 {},     0.0,    stretch, 0.0};
  return meetFirst(cloud, kind, numbers, met) ? std::optional(met) : std::nullopt;
}

}  // namespace

OrderWalker::OrderWalker(const ManyOrders& slab, const TraceSettings& settings, const OrderDeposits& deposits,
                         Film& film, const LaneSteps& steps)
    : slab_(slab),
      deposits_(deposits),
      film_(film),
      steps_(steps),
      seed_(settings.seed),
      least_(kLeastShare * slab.scattered()),
      hazes_(slab.phases().size()),
      perWhite_(perWhiteOf(slab.spectrum().white())) {
  if (!slab.cloud()) return;
  wave_ = std::make_unique<Wave>(*slab.cloud(), slab.engines(), *slab.paths(), settings, steps);
  crystals_.resize(slab.cloud()->populations().size());
}

const TraceCounts& OrderWalker::counts() const {
  static const TraceCounts none;
  return wave_ ? wave_->counts() : none;
}

void OrderWalker::follow(std::uint64_t first, std::uint64_t count) {
  const std::uint64_t end = first + count;
  while (first < end || !walks_.empty()) {
    while (first < end && walks_.size() < kWalks) begin(first++);
    for (std::vector<Group>* groups : {&crystals_, &hazes_})
      for (Group& group : *groups) {
        group.queue.count = 0;
        group.walks.clear();
      }
    for (std::size_t walk = 0; walk < walks_.size(); ++walk) drawCrystal(walk);
    for (std::size_t p = 0; p < crystals_.size(); ++p) scatterByCrystals(static_cast<int>(p));
    for (std::size_t h = 0; h < hazes_.size(); ++h) scatterByHaze(static_cast<int>(h));
    std::erase_if(walks_, [](const Walk& walk) { return walk.ended; });
  }
}

/// Light that comes from the sun.
void OrderWalker::begin(std::uint64_t number) {
  WalkNumbers numbers(seed_, bundleOf(number, 0), 0);
  const double u1 = numbers.next(), u2 = numbers.next();
  Walk walk{number, slab_.light(numbers.next()), 0.0, slab_.sunlight(u1, u2), Vec3(0.0), {}, {}, 0.0};
  const FixedLight units = toFixedLight(walk.light.xyz, perWhite_);
  light_.light.addUnits(walk.light.light == walk.light.xyz.y ? units.y : toFixed(walk.light.light));
  light_.xyz[0].addUnits(units.x);
  light_.xyz[1].addUnits(units.y);
  light_.xyz[2].addUnits(units.z);
  if (!(walk.sunlight.z < 0.0)) return;  // from below the horizon
  walk.iceIndex = slab_.iceIndex(walk.light.wavelength, number);
  const double depth = slab_.depthFrom({}, walk.sunlight);
  // Light from the upper parts of a low sun's disc brings more to a level surface.
  const double brought = -walk.sunlight.z / slab_.sun().toCentre().z;
  walk.weight = brought * takenOver(depth);
  ledger_.in.add(brought);
  ledger_.direct.add(brought - walk.weight);
  if (!(walk.weight > 0.0)) return;
  goOn(walk, walk.sunlight, depth, numbers.next());
  walks_.push_back(walk);
}

/// To the next crystal, somewhere between here and where the slab ends after `depth`.
void OrderWalker::goOn(Walk& walk, const Vec3& direction, double depth, double u) {
  walk.direction = direction;
  const SlabPlace start = walk.place;
  const bool goesDown = direction.z < 0.0;
  const FlightPlaces places(
      depth, slab_.depthFrom(start, -direction),
      {goesDown ? deposits_.fromBelow : deposits_.fromAbove, goesDown ? deposits_.fromAbove : deposits_.fromBelow});
  const double there = places.at(u);
  walk.place = slab_.onward(start, direction, there / depth);
  walk.way = slab_.wayTo(walk.place, start, direction);
  const double before = std::max(0.0, depth - slab_.depthFrom({walk.way.layer, walk.way.from}, direction));
  walk.inLayer = places.weight(before, std::min(depth, before + walk.way.depth));
  walk.atPlace = places.weightAt(there);
  if (places.isGuided()) walk.importance = std::min(1.0, walk.atPlace);
}

void OrderWalker::drawCrystal(std::size_t index) {
  Walk& walk = walks_[index];
  ++walk.step;
  WalkNumbers numbers(seed_, bundleOf(walk.number, walk.step), 0);
  while (!proposeCrystal(slab_.kindAt(walk.place.layer, numbers.next()), index, numbers)) {
  }
}

/// A crystal by its shadow on light of the walk's direction; false where another one has to be proposed.
bool OrderWalker::proposeCrystal(const ManyOrders::Kind& kind, std::size_t index, WalkNumbers& numbers) {
  const Walk& walk = walks_[index];
  Group& group = (kind.isHaze ? hazes_ : crystals_)[static_cast<std::size_t>(kind.population)];
  RayQueue& queue = group.queue;
  const auto place = static_cast<std::size_t>(queue.count);
  queue.makeRoom(queue.count + 1);
  if (!kind.isHaze) {
    const auto crystal = proposedCrystal(*slab_.cloud(), kind, walk.direction, numbers);
    if (!crystal) return false;
    const auto put = [place](RayQueue::Row* rows, const Triple<double>& v) {
      rows[0][place] = v.x;
      rows[1][place] = v.y;
      rows[2][place] = v.z;
    };
    put(queue.crystalX, crystal->x);
    put(queue.crystalY, crystal->y);
    put(queue.crystalZ, crystal->z);
    put(queue.lightWorld, {walk.direction.x, walk.direction.y, walk.direction.z});
    put(queue.lightCrystal, crystal->light);
    put(queue.point, crystal->point);
    queue.face[place] = crystal->face;
    queue.stretch[place] = crystal->stretch;
    queue.shadow[place] = crystal->shadow;
  }
  queue.bundle[place] = bundleOf(walk.number, walk.step);
  queue.weight[place] = 1.0;
  ++queue.count;
  group.walks.push_back(index);
  return true;
}

void OrderWalker::putLight(Group& group) {
  for (std::size_t place = 0; place < group.walks.size(); ++place) {
    group.queue.light[place] = walks_[group.walks[place]].light;
    group.queue.iceIndex[place] = walks_[group.walks[place]].iceIndex;
  }
}

void OrderWalker::scatterByCrystals(int population) {
  Group& group = crystals_[static_cast<std::size_t>(population)];
  if (group.walks.empty()) return;
  putLight(group);
  const Cloud& cloud = *slab_.cloud();
  const bool isIdeal = cloud.optics(population).isIdeal();
  if (!isIdeal) cloud.putOptics(population, cloud.span(population), seed_, group.queue);
  ExitList& exits = wave_->exitsOf(group.queue, population);
  exits.layer.resize(static_cast<std::size_t>(exits.count));
  byBundle_.sort(group.queue, exits.ray, exits.count);
  for (std::size_t place = 0; place < group.walks.size(); ++place) {
    Walk& walk = walks_[group.walks[place]];
    ways_.clear();
    for (int i = byBundle_.begin(static_cast<int>(place)); i < byBundle_.begin(static_cast<int>(place) + 1); ++i) {
      const int exit = byBundle_.item(i);
      if (exits.undeviated[static_cast<std::size_t>(exit)] == 0.0)
        ways_.push_back({exit, exits.energy[static_cast<std::size_t>(exit)], 0.0, 0.0});
    }
    WalkNumbers numbers(seed_, bundleOf(walk.number, walk.step), kBehind);
    settle(walk, exits, isIdeal ? 0.0 : group.queue.absorbed[place], numbers);
  }
  film_.add({group.queue, exits, 1, population,
             slab_.cloud()->populations()[static_cast<std::size_t>(population)].mesh(), steps_});
}

void OrderWalker::scatterByHaze(int haze) {
  Group& group = hazes_[static_cast<std::size_t>(haze)];
  if (group.walks.empty()) return;
  putLight(group);
  const PhaseFunction& phase = slab_.phases()[static_cast<std::size_t>(haze)];
  ExitList& exits = hazeExits_;
  exits.count = 0;
  exits.reserve(static_cast<int>(group.walks.size()) * kHazeExits + RayQueue::kSpare);
  exits.layer.resize(exits.energy.size());
  for (std::size_t place = 0; place < group.walks.size(); ++place) {
    Walk& walk = walks_[group.walks[place]];
    WalkNumbers numbers(seed_, bundleOf(walk.number, walk.step), kBehind);
    const Mat3 frame = frameAround(walk.direction);
    ways_.clear();
    for (int k = 0; k < kHazeExits; ++k) {
      const double cosine = phase.cosineAt((k + numbers.next()) / kHazeExits);
      const double sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
      const portable::SinCos turn = portable::sincos(2.0 * kPi * numbers.next());
      const Vec3 direction = frame * Vec3(sine * turn.cos, sine * turn.sin, cosine);
      const auto exit = static_cast<std::size_t>(exits.count);
      for (int axis = 0; axis < 3; ++axis) exits.lightDirWorld[axis][exit] = direction[axis];
      exits.ray[exit] = static_cast<double>(place);
      exits.energy[exit] = 1.0 / kHazeExits;
      exits.undeviated[exit] = exits.order[exit] = 0.0;
      ways_.push_back({exits.count++, 1.0 / kHazeExits, 0.0, 0.0});
    }
    settle(walk, exits, 0.0, numbers);
  }
  film_.add({group.queue, exits, 1, 0, slab_.someMesh(), steps_});
}

/// What becomes of a walk's light behind a crystal, which has absorbed a share of it.
void OrderWalker::settle(Walk& walk, ExitList& exits, double absorbed, WalkNumbers& numbers) {
  double deviated = 0.0;
  for (Way& way : ways_) {
    const SlabCrossing crossing = slab_.crossing(walk.place.layer, exits.lightDir(way.exit));
    way.on = takenOver(crossing.depthFrom(walk.place.down));
    way.out = 1.0 - way.on;
    deviated += way.energy;
    deposit(walk, exits, way, crossing);
  }
  const double u = numbers.next();
  if (u < deviated) {
    scatter(walk, exits, deviated, numbers);
  } else if (u < deviated + absorbed) {
    ledger_.absorbed.add(walk.weight);
    walk.ended = true;
  }
  if (walk.ended || walk.step < kMostSteps) return;
  ledger_.cutOff.add(walk.weight);
  walk.ended = true;
}

void OrderWalker::deposit(const Walk& walk, ExitList& exits, const Way& way, const SlabCrossing& crossing) {
  const auto exit = static_cast<std::size_t>(way.exit);
  const Vec3 direction = exits.lightDir(way.exit);
  const int order = walk.order + 1;
  // What plates at rest send back into the sun's own direction is seen in the sun.
  if (order < deposits_.first || isSameDirection<double>(direction, walk.sunlight)) {
    exits.undeviated[exit] = 1.0;
    return;
  }
  double sine = std::abs(direction.z), out = 0.0;
  if (sine >= kLevel) {
    out = slab_.meanOut(walk.way, crossing);
  } else {
    sine = kLevel;
    const Vec3 seen(direction.x, direction.y, std::copysign(kLevel, direction.z));
    out = slab_.meanOut(walk.way, slab_.crossing(walk.place.layer, seen));
  }
  exits.energy[exit] = deposits_.scale * walk.weight * walk.inLayer * way.energy * out / sine;
  if (deposits_.layerOf) exits.layer[exit] = deposits_.layerOf(order);
}

/// Light is deviated by the crystal. It goes on along one of the ways, if it does.
void OrderWalker::scatter(Walk& walk, const ExitList& exits, double deviated, WalkNumbers& numbers) {
  ++walk.order;
  double on = 0.0;
  for (Way& way : ways_) on += way.energy * way.on;
  const double here = walk.weight * walk.atPlace;
  ledger_.drawn.add(walk.weight - here);
  const double rest = here * on / deviated, least = std::min(least_ * walk.importance, here);
  double next = 0.0;  // what the walk weighs from here on
  if (walk.order >= slab_.orders())
    ledger_.leftOut.add(rest);
  else if (rest >= least)
    next = rest;
  else if (numbers.next() * least < rest)
    next = least;
  const double out = here - (walk.order >= slab_.orders() ? rest : next);
  countOut(walk, exits, out);
  walk.weight = next;
  walk.ended = !(next > 0.0);
  if (walk.ended) return;
  double left = numbers.next() * on;
  const Way* chosen = nullptr;
  for (const Way& way : ways_) {
    if (!(way.on > 0.0)) continue;
    chosen = &way;
    if ((left -= way.energy * way.on) < 0.0) break;
  }
  const Vec3 direction = exits.lightDir(chosen->exit);
  goOn(walk, direction, slab_.depthFrom(walk.place, direction), numbers.next());
}

/// Shares light out among the ways by what leaves the slab along each.
void OrderWalker::countOut(const Walk& walk, const ExitList& exits, double light) {
  if (!(light > 0.0)) return;
  double above = 0.0, below = 0.0;
  for (const Way& way : ways_) (exits.lightDir(way.exit).z < 0.0 ? below : above) += way.energy * way.out;
  const double all = above + below, share = all > 0.0 ? above / all : 0.5;
  ledger_.above[OrderLedger::placeOf(walk.order)].add(light * share);
  ledger_.below[OrderLedger::placeOf(walk.order)].add(light * (1.0 - share));
}

}  // namespace parhelion
