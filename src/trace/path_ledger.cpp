// SPDX-License-Identifier: Apache-2.0
#include "trace/path_ledger.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include <glm/geometric.hpp>

#include "crystal/raypath/halo_numbers.h"
#include "crystal/raypath/halo_paths.h"
#include "crystal/raypath/path_symmetry.h"
#include "crystal/raypath/stance.h"
#include "math/random.h"
#include "trace/bundle_bins.h"

namespace parhelion {

namespace {

/// A number in (0, 1) for an exit, whatever thread meets it.
double chanceOf(std::uint64_t ray, int order) {
  return toUnitInterval(
      randomWords<std::uint64_t>(0, RandomPurpose::pilot, static_cast<std::uint32_t>(order), ray).first);
}

/// Where samples, all of the same light, lie densest: first within a wide circle, then within a narrow one about what
/// that has found.
Vec3 densestAmong(const std::vector<Vec3>& samples) {
  constexpr double kWide = radians(2.0), kNarrow = radians(0.5);
  const auto meanAround = [&](const Vec3& centre, double radius) {
    const double least = std::cos(radius);
    Vec3 sum(0.0);
    int count = 0;
    for (const Vec3& sample : samples)
      if (glm::dot(sample, centre) >= least) {
        sum += sample;
        ++count;
      }
    return std::pair(count, count > 0 ? glm::normalize(sum) : centre);
  };
  Vec3 densest = samples.front();
  int most = 0;
  for (const Vec3& sample : samples) {
    const auto [count, mean] = meanAround(sample, kWide);
    // Of places that are equally dense the one nearest to the sun's side, so that noise decides as little as can be.
    if (count <= most) continue;
    most = count;
    densest = sample;
  }
  Vec3 peak = densest;
  int best = 0;
  for (const Vec3& sample : samples) {
    if (glm::dot(sample, densest) < std::cos(kWide)) continue;
    const auto [count, mean] = meanAround(sample, kNarrow);
    if (count <= best) continue;
    best = count;
    peak = mean;
  }
  return peak;
}

/// The names of halos whose patterns take a class of a population's paths, in crystals of that index. Names are those
/// of ice: elsewhere only light that no wedge bends goes where they say.
class HaloNames {
 public:
  HaloNames(const Population& population, double index)
      : faces_(population.mesh().faces()), isIce_(std::abs(index - kIndexOfIce) < kNearIce) {
    if (faces_.size() > kMostPatternFaces) return;
    const auto stance = stanceOf(population);
    const bool turnsFreely = stance && *stance != Stance::parry && *stance != Stance::lowitz;
    for (const double turn : turnsOf(population.mesh(), turnsFreely)) {
      const std::vector<int> numbers = haloNumbers(population.mesh(), turn);
      for (const HaloPath& halo : haloPaths()) {
        if (!stance || std::ranges::find(halo.stances, *stance) == halo.stances.end()) continue;
        const PathPattern pattern = parsePathPattern(halo.pattern);
        const SymmetricPattern own[] = {
            {&pattern, pathSymmetries(population.mesh(), population.orientation(), pattern.symmetry)}};
        automata_.emplace_back(halo.name, PathAutomaton(numbers, own));
      }
    }
  }
  std::string of(const PathClass& path) const {
    std::string names;
    if (path.isLong || (!isIce_ && isBent(path))) return names;
    std::vector<std::string_view> all;
    for (const auto& [name, automaton] : automata_)
      if (automaton.acceptedAfter(path.faces).any() && std::ranges::find(all, name) == all.end()) all.push_back(name);
    for (const std::string_view name : all) names.append(names.empty() ? "" : " / ").append(name);
    return names;
  }

 private:
  static constexpr double kIndexOfIce = 1.31, kNearIce = 0.025;  // of visible light, and what people say for it

  /// Whether light leaves through another face, as the reflections inside show it, than one parallel to its entry.
  bool isBent(const PathClass& path) const {
    if (path.faces.size() < 2) return false;
    Vec3 exit = faces_[path.faces.back()].normal;
    for (std::size_t i = path.faces.size() - 2; i > 0; --i) {
      const Vec3& normal = faces_[path.faces[i]].normal;
      exit -= 2.0 * glm::dot(exit, normal) * normal;
    }
    constexpr double kParallel = 1e-6;
    return glm::length(exit + faces_[path.faces.front()].normal) > kParallel;
  }

  std::span<const Face> faces_;
  bool isIce_;
  std::vector<std::pair<std::string_view, PathAutomaton>> automata_;
};

}  // namespace

PathLedger::PathLedger(const Cloud& cloud, const PathLedgerScope& scope)
    : cloud_(cloud), scope_(scope), known_(cloud.populations().size()) {
  if (scope.view) camera_.emplace(*scope.view);
  for (const Population& population : cloud.populations())
    populations_.push_back(
        {PathClasses(population.mesh(), pathSymmetries(population.mesh(), population.orientation(), scope.symmetry)),
         {},
         {},
         {},
         {}});
}

std::unique_ptr<Film> PathLedger::forThread() { return std::make_unique<PathLedger>(cloud_, scope_); }

int PathLedger::numberOf(OfPopulation& own, const PathClass& path) {
  const auto [found, isNew] = own.numberOf.try_emplace(path, static_cast<int>(own.sums.size()));
  if (isNew) {
    own.sums.emplace_back();
    own.classAt.push_back(path);
  }
  return found->second;
}

int PathLedger::classOf(int population, const PathCode::Words& words, int count) {
  const auto [found, isNew] = known_[static_cast<std::size_t>(population)].try_emplace({words, count}, 0);
  if (isNew) {
    OfPopulation& own = populations_[static_cast<std::size_t>(population)];
    found->second = numberOf(own, own.classes.of(words, count));
  }
  return found->second;
}

bool PathLedger::isInScope(bool undeviated, int layer, const Vec3& toSky) const {
  if (undeviated) return false;
  if (scope_.layer && layer != *scope_.layer) return false;
  if (camera_ && !camera_->project(toSky)) return false;
  return !scope_.region || glm::dot(toSky, scope_.region->toCentre) >= std::cos(scope_.region->radius);
}

void PathLedger::sample(Sums& sums, const Vec3& toSky, double energy, std::uint64_t ray, int order) const {
  // Efraimidis & Spirakis 2006: with these keys, each sample is drawn in proportion to its light.
  const double key = std::log(chanceOf(ray, order)) / energy;
  if (sums.samples.size() == kSamples) {
    if (key <= sums.samples.front().key) return;
    std::pop_heap(sums.samples.begin(), sums.samples.end());
    sums.samples.pop_back();
  }
  sums.samples.push_back({key, toSky});
  std::push_heap(sums.samples.begin(), sums.samples.end());
}

int PathLedger::add(const TracedRays& traced) {
  const auto& [queue, exits, members, population, mesh, steps] = traced;
  OfPopulation& own = populations_[static_cast<std::size_t>(population)];
  ByBundle byBundle;
  byBundle.sort(queue, exits.ray, exits.count);
  BundleDeposits<double> deposits;
  int placed = 0;
  for (int place = 0; place < queue.count; ++place) {
    deposits.clear();
    double all = 0.0;
    for (int i = byBundle.begin(place); i < byBundle.begin(place + 1); ++i) {
      const int exit = byBundle.item(i), ray = static_cast<int>(exits.ray[exit]);
      const Vec3 toSky = -exits.lightDir(exit);
      const int layer = scope_.layer ? exits.layer[static_cast<std::size_t>(exit)] : 0;
      if (!isInScope(exits.undeviated[exit] != 0.0, layer, toSky)) continue;
      const int order = static_cast<int>(exits.order[exit]);
      const double light = exits.energy[exit] * queue.light[ray].light;
      const int number = classOf(population, {exits.pathFirst[exit], exits.pathLast[exit]}, order + 1);
      deposits.add(number, light);
      all += light;
      const std::uint64_t index = queue.bundle[place] * static_cast<std::uint64_t>(queue.members) +
                                  static_cast<std::uint64_t>(queue.memberOf(ray));
      if (light > 0.0)
        sample(own.sums[static_cast<std::size_t>(number)], shown(population, toSky), light, index, order);
      if (light > brightest_ || (light == brightest_ && index < brightestRay_)) {
        brightest_ = light;
        brightestRay_ = index;
      }
      ++placed;
    }
    for (const auto& [number, light] : deposits.all()) {
      Sums& sums = own.sums[static_cast<std::size_t>(number)];
      sums.light.add(light);
      sums.squares.add(light * light);
      sums.withAll.add(light * all);
    }
    all_.add(all);
    allSquares_.add(all * all);
    for (int member = 0; member < members; ++member)
      intercepted_.add(queue.weight[place] * queue.light[queue.ray(member, place)].light);
  }
  return placed;
}

Vec3 PathLedger::shown(int population, const Vec3& toSky) const {
  // Right of the sun is as good as left of it.
  const bool mirrored = cloud_.populations()[static_cast<std::size_t>(population)].isMirrorSymmetric();
  return {toSky.x, mirrored && !scope_.region ? -std::abs(toSky.y) : toSky.y, toSky.z};
}

void PathLedger::add(const Beam& beam) {
  if (!(beam.light > 0.0) || !isInScope(beam.undeviated, beam.layer, beam.toSky)) return;
  OfPopulation& own = populations_[static_cast<std::size_t>(beam.population)];
  const auto number = static_cast<std::size_t>(classOf(beam.population, beam.faces, beam.count));
  if (own.copy.size() <= number) own.copy.resize(number + 1, 0.0);
  own.copy[number] += beam.light;
  copyAll_ += beam.light;
  sample(own.sums[number], shown(beam.population, beam.toSky), beam.light, beam.point, beam.number);
}

void PathLedger::endCopy(double intercepted) {
  for (OfPopulation& own : populations_) {
    for (std::size_t number = 0; number < own.copy.size(); ++number) {
      const double light = own.copy[number];
      Sums& sums = own.sums[number];
      sums.light.add(light);
      sums.squares.add(light * light);
      sums.withAll.add(light * copyAll_);
    }
    own.copy.clear();
  }
  all_.add(copyAll_);
  allSquares_.add(copyAll_ * copyAll_);
  intercepted_.add(intercepted);
  copyAll_ = 0.0;
}

void PathLedger::merge(Film& fromThread) {
  auto& other = dynamic_cast<PathLedger&>(fromThread);
  for (std::size_t p = 0; p < populations_.size(); ++p) {
    OfPopulation &own = populations_[p], &more = other.populations_[p];
    for (std::size_t i = 0; i < more.sums.size(); ++i) {
      Sums& sums = own.sums[static_cast<std::size_t>(numberOf(own, more.classAt[i]))];
      sums.light.merge(more.sums[i].light);
      sums.squares.merge(more.sums[i].squares);
      sums.withAll.merge(more.sums[i].withAll);
      sums.samples.insert(sums.samples.end(), more.sums[i].samples.begin(), more.sums[i].samples.end());
      if (sums.samples.size() > kSamples) {
        const auto last = sums.samples.begin() + kSamples;  // of the highest keys
        std::nth_element(sums.samples.begin(), last, sums.samples.end());
        sums.samples.erase(last, sums.samples.end());
      }
      std::make_heap(sums.samples.begin(), sums.samples.end());
    }
    more = {more.classes, {}, {}, {}, {}};
    other.known_[p].clear();
  }
  intercepted_.merge(other.intercepted_);
  all_.merge(other.all_);
  allSquares_.merge(other.allSquares_);
  if (other.brightest_ > brightest_ || (other.brightest_ == brightest_ && other.brightestRay_ < brightestRay_)) {
    brightest_ = other.brightest_;
    brightestRay_ = other.brightestRay_;
  }
  other.intercepted_ = other.all_ = {};
  other.allSquares_ = {};
  other.brightest_ = 0.0;
}

double PathLedger::errorOf(const Sums& sums) const {
  const double all = all_.value(), share = sums.light.value() / all;
  // Of a quotient of sums over independent bundles.
  const double variance =
      sums.squares.value() - 2.0 * share * sums.withAll.value() + share * share * allSquares_.value();
  return std::sqrt(std::max(0.0, variance)) / all;
}

double PathLedger::largestError() const {
  double largest = 0.0;
  for (const OfPopulation& own : populations_)
    for (const Sums& sums : own.sums) largest = std::max(largest, errorOf(sums));
  return largest;
}

std::vector<PathLedger::Entry> PathLedger::entries(double wavelength) const {
  std::vector<Entry> entries;
  const double all = all_.value();
  for (std::size_t p = 0; p < populations_.size(); ++p) {
    const OfPopulation& own = populations_[p];
    const double index = cloud_.iceIndex(wavelength, 0);
    const HaloNames names(cloud_.populations()[p], index);
    for (std::size_t i = 0; i < own.sums.size(); ++i) {
      const Sums& sums = own.sums[i];
      const double share = sums.light.value() / all;
      std::vector<Sample> samples = sums.samples;
      std::sort(samples.begin(), samples.end());
      std::vector<Vec3> toSky;
      for (const Sample& one : samples) toSky.push_back(one.toSky);
      // Light in the sun's vertical lies on both sides of it.
      constexpr std::size_t kKnown = 64;
      if (cloud_.populations()[p].isMirrorSymmetric() && !scope_.region && toSky.size() >= kKnown)
        for (const Sample& one : samples) toSky.emplace_back(one.toSky.x, -one.toSky.y, one.toSky.z);
      entries.push_back({own.classes.text(own.classAt[i]), static_cast<int>(p), share, errorOf(sums),
                         densestAmong(toSky), own.classes.leastDeviation(own.classAt[i], index),
                         names.of(own.classAt[i])});
    }
  }
  std::ranges::sort(entries, [](const Entry& a, const Entry& b) {
    return std::tie(b.share, a.population, a.path) < std::tie(a.share, b.population, b.path);
  });
  return entries;
}

double PathLedger::shareOfIntercepted() const {
  return intercepted_.units() == 0 ? 0.0 : all_.value() / intercepted_.value();
}

std::optional<std::uint64_t> PathLedger::brightestRay() const {
  return brightest_ > 0.0 ? std::optional(brightestRay_) : std::nullopt;
}

}  // namespace parhelion
