// SPDX-License-Identifier: Apache-2.0
#include "render/integrated_paths.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <stdexcept>

#include "beam/light_class.h"
#include "beam/piece_tracer.h"
#include "beam/prism_tracer.h"
#include "beam/sun_frame.h"
#include "crystal/orientation.h"
#include "math/rotation.h"
#include "math/sobol.h"
#include "parallel/loops.h"
#include "render/prism_populations.h"
#include "trace/path_plan.h"

namespace parhelion {

namespace {

// Points are scrambled nets: so many independent copies of them, and of each these are the first and the most.
constexpr int kCopies = 32, kFirstPoints = 64, kMostPoints = 1 << 17;
// Errors fall faster than with the root of points; what more points are asked for than that says.
constexpr double kFall = 0.75, kMore = 1.4;
// The light that a copy intercepts, for the ledger's whole numbers.
constexpr double kPerCopy = 65536.0;
// Light of less than this share is not cut up but follows its middle, and is given up at a thousandth of that.
constexpr double kCutShare = 3e-4;

enum Dimension : int { kZenith, kRoll, kAzimuth, kIndex, kLength, kSunRadius, kSunAngle, kDimensions };

struct Shares {
  double intercepted = 0.0, filtered = 0.0, cutOff = 0.0;
};

Vec3 vectorOf(const Triple<double>& v) { return {v.x, v.y, v.z}; }

/// The rotation that takes the zenith to the sun.
Mat3 toSunFrom(const Vec3& toSun) {
  const SunFrame frame(toSun);
  return {-frame.up, frame.left, toSun};
}

/// What is the same for all points of a population.
class PathPopulation {
 public:
  PathPopulation(const Scene& scene, const Cloud& cloud, const PathPlan& plan, int number, bool tellsSidesApart)
      : cloud_(cloud),
        plan_(plan),
        number_(number),
        population_(cloud.populations()[static_cast<std::size_t>(number)]),
        settings_(scene.populations[static_cast<std::size_t>(number)]),
        indices_(scene, Counted::energy),
        tellsSidesApart_(tellsSidesApart || standingOf(settings_.orientation)),
        wanted_(wantedBy(plan.automaton(number), numbersOf(population_))) {
    const std::vector<int> numbers = numbersOf(population_);
    for (std::size_t face = 0; face < numbers.size(); ++face) {
      const int known = numbers[face];
      chains_.numberOf[static_cast<std::size_t>(known >= 3 ? known - 3 : kUpperEnd + known - 1)] =
          static_cast<int>(face);
    }
    if (!cloud.sun().isPoint()) disc_ = cloud.sun().disc();
    if (!population_.stretch()) length_ = prismsOf(settings_, 1).front().length;
  }

  /// Adds the light of a point, times a factor.
  void add(const SobolPoints& points, std::uint64_t point, double factor, PathLedger& ledger, Shares& shares) {
    std::array<double, kDimensions> u;
    for (int d = 0; d < kDimensions; ++d) u[static_cast<std::size_t>(d)] = points.at(point, d);
    const Vec3 toSun = disc_ ? vectorOf(disc_->toPoint(u[kSunRadius], u[kSunAngle])) : cloud_.sun().toCentre();
    const Mat3 rotation = rotationAt(u, toSun);
    const IndexColour ice = indices_.at(u[kIndex]);
    const double length = population_.stretch() ? 2.0 * population_.stretch()->at(u[kLength]) : length_;
    if (!tracer_ || length != tracedLength_ || ice.index != tracedIndex_) {
      tracedLength_ = length;
      tracedIndex_ = ice.index;
      tracer_.emplace(section_, length, ice.index, kCutShare, false, wanted_);
      outside_.emplace(section_, length, ice.index, kCutShare);
    }
    const Vec3 lightDir = -toSun * rotation;  // by its parts along the columns
    outside_->meetOutside(lightDir, light_);
    chains_.all.clear();
    tracer_->trace(lightDir, light_, &chains_);

    const double per = factor * ice.xyz[1] * 4.0 / section_.surface(length);
    shares.intercepted += per * light_.totalShadow();
    for (std::size_t face = 0; face < kPrismFaces; ++face)
      shares.cutOff += per * light_.shadow[face] * (1.0 - light_.reflectance[face]) * light_.cutOff[face];
    std::uint64_t allowed = ~std::uint64_t{0};
    if (plan_.hasTilts(number_)) allowed = plan_.layersFor(number_, rotation[1], rotation[2]);
    const RelativeIndexOf<double> index(ice.index);
    const Triple<double> s{lightDir.x, lightDir.y, lightDir.z};
    int number = 0;
    const auto leave = [&](const LightClass& of, const ClassExit<double>& exit, const LightChain& chain) {
      const double light = per * chain.light * exit.transmittance;
      if (!plan_.keeps(number_, chain.state)) {
        shares.filtered += light;
        return;
      }
      const int layer = plan_.layerOf(number_, chain.state, allowed);
      ledger.add({number_, chain.faces, chain.count, -(rotation * vectorOf(exit.lightDir)), light, of.isUndeviated(),
                  layer, point, number++});
    };
    for (int face = 0; face < kPrismFaces; ++face) {
      const auto f = static_cast<std::size_t>(face);
      if (light_.shadow[f] == 0.0) continue;
      const LightClass of(kInsideClasses + face);
      leave(of, of.exit(s, index),
            {of.of, light_.shadow[f], wanted_.next(WantedPaths::kStart, face), code_.with({}, chains_.numberOf[f], 0),
             1});
    }
    exits_.fill(std::nullopt);
    for (LightChain& chain : chains_.all) {
      const int classNumber = (chain.of.entry * kPrismElements + chain.of.element) * kPrismFaces + chain.of.exit;
      const LightClass of(classNumber);
      auto& exit = exits_[static_cast<std::size_t>(classNumber)];
      if (!exit) exit = of.exit(s, index);
      if (exit->transmittance > 0.0) leave(of, *exit, shortened(chain));
    }
  }

 private:
  static std::vector<int> numbersOf(const Population& population) {
    std::vector<int> numbers;
    for (const Face& face : population.mesh().faces()) numbers.push_back(face.number);
    return numbers;
  }

  /// All light, told apart by the states of an automaton.
  static WantedPaths wantedBy(const PathAutomaton& automaton, const std::vector<int>& numbers) {
    return {automaton, numbers, std::vector<bool>(static_cast<std::size_t>(automaton.states()), true)};
  }

  /// Long paths are known by their first and last face.
  LightChain shortened(const LightChain& chain) const {
    if (chain.count <= PathClasses::kLongest) return chain;
    const int exit = chains_.numberOf[static_cast<std::size_t>(chain.of.exit)];
    const int entry = chains_.numberOf[static_cast<std::size_t>(chain.of.entry)];
    LightChain both = chain;
    both.faces = code_.with(code_.with({}, entry, 0), exit, PathClasses::kLongest);
    both.count = PathClasses::kLongest + 1;
    return both;
  }

  /// From the crystal to the world. Random crystals are turned about the sun: what their angle from it decides is then
  /// one number, and their azimuth about it only turns their light. A prism turned by 60 degrees about c is the same;
  /// its mirror image, and what stands on its head, are as likely there, with the same light at the same angle.
  Mat3 rotationAt(const std::array<double, kDimensions>& u, const Vec3& toSun) const {
    const bool isRandom = population_.isFullyRandom(), isAlike = !tellsSidesApart_;
    const auto columns = population_.orientationQuantile().at(u[kZenith] * (isRandom && isAlike ? 0.5 : 1.0),
                                                              u[kAzimuth], isAlike ? 0.5 : u[kRoll]);
    Mat3 rotation(vectorOf(columns.x), vectorOf(columns.y), vectorOf(columns.z));
    if (isAlike) rotation = rotation * rotationZ(kPi / (isRandom ? 6.0 : 3.0) * u[kRoll]);
    return isRandom ? toSunFrom(toSun) * rotation : rotation;
  }

  const Cloud& cloud_;
  const PathPlan& plan_;
  int number_;
  const Population& population_;
  const PopulationSettings& settings_;
  PrismSection section_;
  IndexSampler indices_;
  bool tellsSidesApart_;
  WantedPaths wanted_;
  std::optional<SunDisc> disc_;
  double length_ = 0.0, tracedLength_ = 0.0, tracedIndex_ = 0.0;
  std::optional<PieceTracer> tracer_;
  std::optional<PrismTracer> outside_;
  PrismLight light_;
  PathCode code_{kPrismFaces};
  LightChains chains_;
  std::array<std::optional<ClassExit<double>>, kInsideClasses> exits_;
};

class Integration {
 public:
  Integration(const Scene& scene, const Cloud& cloud, const PathLedgerScope& scope)
      : scene_(scene),
        cloud_(cloud),
        scope_(scope),
        plan_(cloud, scene.trace.paths, true),
        // Patterns may tell apart what is alike.
        tellsSidesApart_(scope.symmetry == PathSymmetry::none || plan_.hasFilter() || plan_.layers() > 0) {}

  IntegratedPaths run(double error) {
    long all = 0;
    for (int points = kFirstPoints;;) {
      IntegratedPaths result = integrate(points);
      result.directions = all += result.directions;
      result.reached = result.error <= error;
      if (result.reached || points == kMostPoints) return result;
      const double more = std::clamp(kMore * std::pow(result.error / error, 1.0 / kFall), 2.0, 64.0);
      int next = points;
      while (next < more * points && next < kMostPoints) next *= 2;
      points = next;
    }
  }

 private:
  IntegratedPaths integrate(int points) const {
    IntegratedPaths result{PathLedger(cloud_, scope_)};
    std::vector<std::unique_ptr<Film>> ledgers(kCopies);
    std::array<Shares, kCopies> shares;
    PathLedger& ledger = result.ledger;
    for (auto& copy : ledgers) copy = ledger.forThread();
    forEach(std::size_t{kCopies},
            [&](std::size_t copy) { shares[copy] = addCopy(copy, points, dynamic_cast<PathLedger&>(*ledgers[copy])); });
    Shares sum;
    for (std::size_t copy = 0; copy < kCopies; ++copy) {
      ledger.merge(*ledgers[copy]);
      sum.intercepted += shares[copy].intercepted;
      sum.filtered += shares[copy].filtered;
      sum.cutOff += shares[copy].cutOff;
    }
    result.filtered = sum.filtered / sum.intercepted;
    result.cutOff = sum.cutOff / sum.intercepted;
    for (const PopulationSettings& population : scene_.populations)
      if (population.weight > 0.0) result.directions += long{kCopies} * points;
    result.error = ledger.largestError();
    return result;
  }

  Shares addCopy(std::size_t copy, int points, PathLedger& ledger) const {
    Shares shares;
    double all = 0.0;
    for (const PopulationSettings& population : scene_.populations) all += population.weight;
    const std::size_t count = scene_.populations.size();
    for (std::size_t k = 0; k < count; ++k) {
      const double weight = scene_.populations[k].weight / all;
      if (weight == 0.0) continue;
      PathPopulation population(scene_, cloud_, plan_, static_cast<int>(k), tellsSidesApart_);
      const std::uint64_t seed = (scene_.trace.seed * kCopies + copy) * count + k;
      const SobolPoints sobol(seed);
      const std::uint64_t first = copy * static_cast<std::uint64_t>(kMostPoints);
      for (int point = 0; point < points; ++point)
        population.add(sobol, first + static_cast<std::uint64_t>(point), weight * kPerCopy / points, ledger, shares);
    }
    ledger.endCopy(shares.intercepted);
    return shares;
  }

  const Scene& scene_;
  const Cloud& cloud_;
  PathLedgerScope scope_;
  PathPlan plan_;
  bool tellsSidesApart_;
};

}  // namespace

std::string objectionToIntegratedPaths(const Scene& scene) {
  for (const PopulationSettings& population : scene.populations)
    if (const std::string objection = objectionTo(scene, population, false); !objection.empty())
      return "population " + population.name + " " + objection;
  return {};
}

IntegratedPaths integratePaths(const Scene& scene, const Cloud& cloud, const PathLedgerScope& scope, double error) {
  if (const std::string objection = objectionToIntegratedPaths(scene); !objection.empty())
    throw std::invalid_argument(objection);
  return Integration(scene, cloud, scope).run(error);
}

}  // namespace parhelion
