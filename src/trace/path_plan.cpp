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

bool isNamed(const std::vector<std::string>& names, const std::string& name) {
  return names.empty() || std::ranges::find(names, name) != names.end();
}

/// Where crystals of an orientation rest: the zenith angle of the axis that tilts. Of angles beyond a pole, where the
/// axis comes down.
double restOf(const OrientationSettings& orientation) {
  const auto centre = [](const AngleDistribution& zenith) {
    return std::abs(std::remainder(centreOf(zenith), 2.0 * kPi));
  };
  return std::visit(Overloaded{
                        [](const RandomOrientation&) { return 0.0; },
                        [&](const AxisOrientation& axis) { return centre(axis.zenith); },
                        [&](const LowitzOrientation& lowitz) { return centre(lowitz.axisZenith); },
                    },
                    orientation);
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

PathPlan::ZenithRange::ZenithRange(double from, double to)
    : fromNowhere_(from < 0.0),
      toNowhere_(to > kPi),
      sinFrom_(std::sin(from)),
      cosFrom_(std::cos(from)),
      sinTo_(std::sin(to)),
      cosTo_(std::cos(to)) {}

PathPlan::PathPlan(const Cloud& cloud, const PathSettings& settings, bool sequences)
    : hasFilter_(settings.filter.has_value()),
      layers_(static_cast<int>(settings.layers.size())),
      record_(recordFor(settings, sequences)) {
  if (record_ == PathRecord::nothing) return;
  if (settings.layers.size() > kMostLayers)
    throw std::invalid_argument("there may be " + std::to_string(kMostLayers) + " layers at the most");
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
    if (own.isOf(population.name()) && own.order.value_or(1) == 1) add(own.paths ? *own.paths : anything(), layer);
  }
  constexpr int kFilter = -1;
  if (settings.filter) add(*settings.filter, kFilter);

  OfPopulation plan{
      PathAutomaton(numbers, patterns), PathCode(static_cast<int>(numbers.size())), {}, {}, {}, {}, false, {}};
  plan.tiltsCrystalY = std::holds_alternative<LowitzOrientation>(population.orientation());
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
    }
    plan.takenBy.push_back(taken);
    plan.layers.push_back(layerIn(taken));
    plan.kept.push_back(kept);
  }
  const double rest = restOf(population.orientation());
  for (int layer = 0; layer < layers_; ++layer) {
    const auto& tilt = settings.layers[static_cast<std::size_t>(layer)].tilt;
    if (tilt && std::ranges::find(decides, layer) != decides.end())
      plan.tilted.push_back(
          {std::uint64_t{1} << layer, {rest - tilt->from, rest + tilt->from}, {rest - tilt->to, rest + tilt->to}});
  }
  return plan;
}

}  // namespace parhelion
