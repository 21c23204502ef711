// SPDX-License-Identifier: Apache-2.0
#include "render/light_parts.h"

#include <algorithm>

#include "crystal/orientation.h"
#include "render/prism_populations.h"
#include "render/traced_sky.h"
#include "trace/path_plan.h"

namespace parhelion {

namespace {

struct PopulationPlan {
  LightParts parts;
  std::string objection;
};

bool tellsPathsApart(const PathSettings& paths) {
  return paths.filter ||
         std::ranges::any_of(paths.layers, [](const LayerSettings& layer) { return layer.paths.has_value(); });
}

/// The light of a population by layer; what no layer has is left out.
LightParts partsByPath(const Cloud& cloud, const PathPlan& plan, int population) {
  std::vector<int> numbers;
  for (const Face& face : cloud.populations()[static_cast<std::size_t>(population)].mesh().faces())
    numbers.push_back(face.number);
  const PathAutomaton& automaton = plan.automaton(population);
  LightParts parts;
  for (int layer = 0; layer <= plan.layers(); ++layer) {
    std::vector<bool> wanted;
    for (int state = 0; state < automaton.states(); ++state)
      wanted.push_back(plan.keeps(population, state) &&
                       plan.layersOf(population)[static_cast<std::size_t>(state)] == layer);
    WantedPaths paths(automaton, numbers, std::move(wanted));
    const bool isAll = paths.others().isNothing();
    // Crystals without any light that is wanted count as what they intercept.
    if (paths.isNothing() && !(layer == plan.layers() && parts.empty())) continue;
    parts.push_back({static_cast<std::size_t>(layer), std::nullopt});
    if (!isAll) parts.back().wanted = std::move(paths);
  }
  return parts;
}

std::vector<PopulationPlan> plansOf(const Scene& scene) {
  const PathSettings& paths = scene.trace.paths;
  std::optional<Cloud> cloud;
  std::optional<PathPlan> plan;
  if (tellsPathsApart(paths)) {
    cloud.emplace(cloudByLight(scene));
    plan.emplace(*cloud, paths);
  }
  std::vector<PopulationPlan> plans;
  for (std::size_t k = 0; k < scene.populations.size(); ++k) {
    const PopulationSettings& population = scene.populations[k];
    PopulationPlan own{{}, objectionTo(scene, population, false)};
    for (const LayerSettings& layer : paths.layers)
      if (own.objection.empty() && layer.tilt && layer.isOf(population.name))
        own.objection = "has light that the layer " + layer.name + " tells apart by tilts";
    if (own.objection.empty() && !plan) {
      const auto first = std::ranges::find_if(paths.layers, [&](const auto& l) { return l.isOf(population.name); });
      own.parts = {{static_cast<std::size_t>(first - paths.layers.begin()), std::nullopt}};
    } else if (own.objection.empty()) {
      own.parts = partsByPath(*cloud, *plan, static_cast<int>(k));
      const bool hasRolls = !standingOf(population.orientation);
      if (hasRolls &&
          std::ranges::any_of(own.parts, [](const auto& p) { return p.wanted && !p.wanted->areAlikeAboutC(); })) {
        own.objection = "has raypaths told apart by side faces that are alike, as by symmetry = none";
        own.parts.clear();
      }
    }
    plans.push_back(std::move(own));
  }
  return plans;
}

}  // namespace

std::vector<LightParts> lightPartsOf(const Scene& scene) {
  std::vector<LightParts> parts;
  for (PopulationPlan& plan : plansOf(scene)) parts.push_back(std::move(plan.parts));
  return parts;
}

std::vector<std::optional<WantedPaths>> keptPathsOf(const Scene& scene) {
  std::vector<std::optional<WantedPaths>> kept(scene.populations.size());
  if (!scene.trace.paths.filter) return kept;
  const Cloud cloud = cloudByLight(scene);
  const PathPlan plan(cloud, {scene.trace.paths.filter, {}});
  for (std::size_t k = 0; k < kept.size(); ++k)
    kept[k] = std::move(partsByPath(cloud, plan, static_cast<int>(k)).front().wanted);
  return kept;
}

std::vector<std::string> objectionsToIntegrating(const Scene& scene) {
  std::vector<std::string> objections;
  for (PopulationPlan& plan : plansOf(scene)) objections.push_back(std::move(plan.objection));
  return objections;
}

}  // namespace parhelion
