// SPDX-License-Identifier: Apache-2.0
#include "trace/path_plan.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "crystal/raypath/path_symmetry.h"
#include "crystal/raypath/stance.h"
#include "math/overloaded.h"

namespace parhelion {

namespace {

double zenithAngle(const Vec3& axis) { return std::atan2(std::hypot(axis.x, axis.y), axis.z); }

bool isNamed(const std::vector<std::string>& names, const std::string& name) {
  return names.empty() || std::ranges::find(names, name) != names.end();
}

/// Whether a pattern speaks of a population at all.
bool speaksOf(const PathPattern& pattern, const Population& population, std::optional<Stance> stance) {
  if (!isNamed(pattern.populations, population.name())) return false;
  return pattern.stances.empty() || (stance && std::ranges::find(pattern.stances, *stance) != pattern.stances.end());
}

PathRecord recordFor(const PathSettings& settings, bool sequences) {
  if (sequences) return PathRecord::sequence;
  return settings.filter || !settings.layers.empty() ? PathRecord::state : PathRecord::nothing;
}

const PathPattern& anything() {
  static const PathPattern any = anyPath();
  return any;
}

}  // namespace

double tiltOf(const OrientationSettings& orientation, const Vec3& crystalY, const Vec3& crystalZ) {
  const auto from = [](const AngleDistribution& rest, const Vec3& axis) {
    // Of angles beyond a pole, where the axis comes down.
    return std::abs(zenithAngle(axis) - std::abs(std::remainder(centreOf(rest), 2.0 * kPi)));
  };
  return std::visit(Overloaded{
                        [&](const RandomOrientation&) { return zenithAngle(crystalZ); },
                        [&](const AxisOrientation& axis) { return from(axis.zenith, crystalZ); },
                        [&](const LowitzOrientation& lowitz) { return from(lowitz.axisZenith, crystalY); },
                    },
                    orientation);
}

PathPlan::PathPlan(const Cloud& cloud, const PathSettings& settings, bool sequences)
    : hasFilter_(settings.filter.has_value()),
      layers_(static_cast<int>(settings.layers.size())),
      record_(recordFor(settings, sequences)) {
  if (record_ == PathRecord::nothing) return;
  if (settings.layers.size() > kMostLayers)
    throw std::invalid_argument("there may be " + std::to_string(kMostLayers) + " layers at the most");
  for (const LayerSettings& layer : settings.layers) tilts_.push_back(layer.tilt);
  for (const Population& population : cloud.populations()) populations_.push_back(planFor(population, settings));
  for (OfPopulation& plan : populations_)
    plan.table = {plan.automaton.table().data(), static_cast<double>(plan.automaton.faces()), plan.code.bits(),
                  plan.code.room()};
}

PathPlan::OfPopulation PathPlan::planFor(const Population& population, const PathSettings& settings) const {
  const CrystalMesh& mesh = population.mesh();
  const auto stance = stanceOf(population);
  std::vector<int> numbers;
  for (const Face& face : mesh.faces()) numbers.push_back(face.number);

  // Patterns that speak of this population, and what each decides: a layer, or the filter.
  std::vector<SymmetricPattern> patterns;
  std::vector<int> decides;
  const auto addOne = [&](const PathPattern& pattern, int what) {
    if (!speaksOf(pattern, population, stance)) return;
    patterns.push_back({&pattern, pathSymmetries(mesh, population.orientation(), pattern.symmetry)});
    decides.push_back(what);
  };
  const auto add = [&](const PathPattern& pattern, int what) {
    addOne(pattern, what);
    for (const PathPattern& other : pattern.others) addOne(other, what);
  };
  for (int layer = 0; layer < layers_; ++layer) {
    const LayerSettings& own = settings.layers[static_cast<std::size_t>(layer)];
    if (isNamed(own.populations, population.name())) add(own.paths ? *own.paths : anything(), layer);
  }
  constexpr int kFilter = -1;
  if (settings.filter) add(*settings.filter, kFilter);

  OfPopulation plan{
      PathAutomaton(numbers, patterns), PathCode(static_cast<int>(numbers.size())), {}, {}, {}, {}, false};
  for (int state = 0; state < plan.automaton.states(); ++state) {
    const PathAutomaton::Patterns& accepted = plan.automaton.accepted(state);
    std::uint64_t taken = 0;
    bool kept = !settings.filter;
    for (std::size_t i = 0; i < patterns.size(); ++i) {
      if (!accepted[i]) continue;
      if (decides[i] == kFilter)
        kept = true;
      else
        taken |= std::uint64_t{1} << decides[i];
      plan.hasTilts |= decides[i] != kFilter && tilts_[static_cast<std::size_t>(decides[i])].has_value();
    }
    plan.takenBy.push_back(taken);
    plan.layers.push_back(layerIn(taken));
    plan.kept.push_back(kept);
  }
  return plan;
}

std::uint64_t PathPlan::layersFor(const Population& population, const Vec3& crystalY, const Vec3& crystalZ) const {
  const double tilt = tiltOf(population.orientation(), crystalY, crystalZ);
  std::uint64_t allowed = ~std::uint64_t{0};
  for (std::size_t layer = 0; layer < tilts_.size(); ++layer)
    if (tilts_[layer] && !(tilt >= tilts_[layer]->from && tilt < tilts_[layer]->to))
      allowed &= ~(std::uint64_t{1} << layer);
  return allowed;
}

}  // namespace parhelion
