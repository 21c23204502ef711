// SPDX-License-Identifier: Apache-2.0
#include "render/integrated_profile.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "beam/scatter_integral.h"
#include "render/light_parts.h"
#include "render/prism_populations.h"

namespace parhelion {

namespace {

// Crystals of spread aspect ratios are as many.
constexpr int kProfileAspects = 16;
// Light is cut up as finely as the error asks for: at a cut share of 1e-4 bins are off by 1e-4 of their light, and at
// 1e-5 it takes twice as long, or three times where it is followed from face to face.
constexpr double kCutOfError = 5e-3, kLeastCut = 1e-6, kMostCut = 1e-4;

/// From which the mean crystal follows.
struct CrystalSums {
  double crystals = 0.0, volume = 0.0, surface = 0.0, shadow = 0.0;
};

/// What counts of randomly oriented crystals' light. Where paths tell the ends apart, what crystals do that stand on
/// their heads is another thing.
std::vector<WantedPaths> wantedOf(const std::optional<WantedPaths>& kept) {
  if (!kept) return {};
  if (kept->areAlikeUpsideDown()) return {*kept};
  return {*kept, kept->upsideDown()};
}

/// Sums of all populations, each by its share of the light.
class Sum {
 public:
  Sum(const IntegralProfileSettings& settings, bool isFiltered)
      : settings_(settings),
        isFiltered_(isFiltered),
        light_(static_cast<std::size_t>(settings.bins), 0.0),
        squares_(static_cast<std::size_t>(settings.bins), 0.0) {}

  void add(const ScatterScene& scene, const ScatterIntegral& part, double share) {
    for (std::size_t bin = 0; bin < light_.size(); ++bin) {
      light_[bin] += share * part.light[bin];
      squares_[bin] += share * part.error[bin] * share * part.error[bin];
    }
    totals_.add(part.totals, share);
    gSquares_ += share * part.gError * share * part.gError;
    pathSquares_ += share * part.pathError * share * part.pathError;
    for (const PrismShare& prism : scene.prisms) {
      const double surface = scene.section.surface(prism.length), crystals = share * prism.share / surface;
      mean_.crystals += crystals;
      mean_.volume += crystals * scene.section.area * prism.length;
      mean_.surface += crystals * surface;
    }
    mean_.shadow += share * part.totals.intercepted / 4.0;
    result_.directions += part.directions;
    result_.patches += part.patches;
    result_.reached = result_.reached && part.reached;
  }

  IntegratedProfile result() {
    const double width = (settings_.to - settings_.from) / settings_.bins;
    for (int k = 0; k < settings_.bins; ++k) {
      const auto bin = static_cast<std::size_t>(k);
      const double light = light_[bin] + (k == 0 && settings_.from == 0.0 ? totals_.undeviated : 0.0);
      result_.bins.push_back(ScatterProfile::binOf(k, settings_.from, width, light, std::sqrt(squares_[bin])));
    }
    if (isFiltered_) result_.filtered = 1.0 - totals_.out - totals_.cutOff;
    result_.summary = summary();
    return std::move(result_);
  }

 private:
  ScatterProfile::Summary summary() const {
    ScatterProfile::Summary s{};
    s.g = totals_.cosine;
    s.gError = std::sqrt(gSquares_);
    s.undeviated = totals_.undeviated;
    s.external = totals_.external;
    s.cutOff = totals_.cutOff;
    s.byOrder.push_back(s.external);
    s.byOrderRest = 1.0 - s.external - s.cutOff - result_.filtered;
    for (const double order : totals_.byOrder) {
      s.byOrder.push_back(order);
      s.byOrderRest -= order;
    }
    s.meanPath = totals_.path;
    s.meanPathError = std::sqrt(pathSquares_);
    s.volume = mean_.volume / mean_.crystals;
    s.surface = mean_.surface / mean_.crystals;
    s.meanProjectedArea = mean_.shadow / mean_.crystals;
    return s;
  }

  IntegralProfileSettings settings_;
  bool isFiltered_;
  std::vector<double> light_, squares_;
  ScatterTotals totals_;
  double gSquares_ = 0.0, pathSquares_ = 0.0;
  CrystalSums mean_;
  IntegratedProfile result_;
};

}  // namespace

std::string objectionToIntegral(const Scene& scene) {
  for (const PopulationSettings& population : scene.populations) {
    if (const std::string objection = objectionTo(scene, population, true); !objection.empty())
      return "population " + population.name + " " + objection;
  }
  return {};
}

IntegratedProfile integrateProfile(const Scene& scene, const IntegralProfileSettings& settings) {
  if (const std::string objection = objectionToIntegral(scene); !objection.empty())
    throw std::invalid_argument(objection);
  double all = 0.0;
  for (const PopulationSettings& population : scene.populations) all += population.weight;
  Sum sum(settings, scene.trace.paths.filter.has_value());
  const std::vector<std::optional<WantedPaths>> kept = keptPathsOf(scene);
  for (std::size_t k = 0; k < kept.size(); ++k) {
    const PopulationSettings& population = scene.populations[k];
    if (population.weight == 0.0) continue;
    // Randomly oriented convex crystals intercept light as they have surface (Cauchy).
    const ScatterScene prisms{PrismSection(), prismsOf(population, kProfileAspects), iceLightOf(scene),
                              wantedOf(kept[k])};
    ScatterAccuracy accuracy;
    accuracy.error = settings.error;
    accuracy.cutShare = std::clamp(kCutOfError * settings.error, kLeastCut, kMostCut);
    accuracy.detailed = settings.detailed;
    sum.add(prisms, integrateScatter(prisms, accuracy, settings.bins, settings.from, settings.to),
            population.weight / all);
  }
  return sum.result();
}

}  // namespace parhelion
