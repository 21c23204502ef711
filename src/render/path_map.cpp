// SPDX-License-Identifier: Apache-2.0
#include "render/path_map.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace parhelion {

namespace {

/// What a family of paths is called, and what it takes.
struct FamilyOfPaths {
  std::string name, pattern;
  std::vector<std::string> populations;
  double share = 0.0;
};

/// The name of an entry's family, and of the halo that it makes, which may be empty.
std::pair<std::string, std::string> calledBy(const PathLedger::Entry& entry, const std::string& population,
                                             const Vec3& toSun) {
  // Where tangent arcs have met (Greenler 1980): at n = 1.31 from 29.2 degrees on.
  constexpr double kTangentArcsMeet = radians(29.2);
  if (entry.name.find("tangent arc") != std::string::npos)
    return {std::asin(toSun.z) < kTangentArcsMeet ? "tangent arcs" : "circumscribed halo", "circumscribed halo"};
  const std::string halo = entry.name.substr(0, entry.name.find(" / "));
  return {halo.empty() ? entry.path + " of " + population : halo, halo};
}

}  // namespace

std::vector<LayerSettings> strongestPaths(const std::vector<PathLedger::Entry>& entries, const Cloud& cloud,
                                          std::size_t most) {
  std::vector<FamilyOfPaths> families;
  for (const PathLedger::Entry& entry : entries) {
    const std::string& population = cloud.populations()[static_cast<std::size_t>(entry.population)].name();
    const auto [name, halo] = calledBy(entry, population, cloud.sun().toCentre());
    auto found = std::ranges::find(families, name, &FamilyOfPaths::name);
    if (found == families.end()) {
      families.push_back({name, halo.empty() ? entry.path : halo, {}, 0.0});
      found = families.end() - 1;
      if (halo.empty()) found->populations = {population};
    }
    found->share += entry.share;
  }
  constexpr double kFaint = 1e-3;
  std::ranges::stable_sort(families, std::greater<>(), [](const FamilyOfPaths& family) {
    return std::pair(family.populations.empty() && family.share > kFaint, family.share);
  });
  if (families.size() > most) families.resize(most);
  std::vector<LayerSettings> layers;
  for (FamilyOfPaths& family : families)
    layers.push_back({family.name, parsePathPattern(family.pattern), family.populations, {}});
  return layers;
}

}  // namespace parhelion
