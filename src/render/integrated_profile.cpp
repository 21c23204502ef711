// SPDX-License-Identifier: Apache-2.0
#include "render/integrated_profile.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "beam/scatter_integral.h"
#include "crystal/population.h"
#include "optics/ice.h"
#include "optics/spectrum.h"

namespace parhelion {

namespace {

// Crystals of spread aspect ratios are as many, each with the same share of the surface.
constexpr int kAspects = 16;
// Nodes at which the spectrum's light is added up, and at which its indices are kept.
constexpr int kSpectrumNodes = 4096, kIndexNodes = 256;

/// The indices of continuous light at even shares of it.
std::vector<double> indicesAtShares(const Spectrum& spectrum, const IceSettings& ice) {
  std::vector<double> light{0.0}, wavelengths;
  for (int k = 0; k < kSpectrumNodes; ++k) {
    const SpectralSample sample = spectrum.sample((k + 0.5) / kSpectrumNodes);
    wavelengths.push_back(sample.wavelength);
    light.push_back(light.back() + sample.light);
  }
  std::vector<double> indices;
  std::size_t cell = 0;
  for (int k = 0; k <= kIndexNodes; ++k) {
    const double wanted = light.back() * k / kIndexNodes;
    while (cell + 1 < wavelengths.size() && light[cell + 1] < wanted) ++cell;
    // Within a cell, from half-way before its wavelength to half-way behind.
    const double before = wavelengths[cell == 0 ? 0 : cell - 1],
                 behind = wavelengths[std::min(cell + 1, wavelengths.size() - 1)];
    const double t = std::clamp((wanted - light[cell]) / (light[cell + 1] - light[cell]), 0.0, 1.0);
    const double from = 0.5 * (before + wavelengths[cell]), to = 0.5 * (wavelengths[cell] + behind);
    indices.push_back(refractiveIndex(ice, from + t * (to - from)));
  }
  return indices;
}

IceLight iceLightOf(const Scene& scene) {
  const Spectrum spectrum(scene.sun.spectrum);
  if (spectrum.lines().empty() && std::holds_alternative<TabulatedIce>(scene.ice))
    return IceLight::continuous(indicesAtShares(spectrum, scene.ice));
  if (const auto* mixture = std::get_if<IceMixture>(&scene.ice)) {
    std::vector<IndexShare> all;
    for (const double index : mixture->indices)
      all.push_back({index, 1.0 / static_cast<double>(mixture->indices.size())});
    return IceLight(all);
  }
  if (const auto* constant = std::get_if<ConstantIce>(&scene.ice)) return IceLight({{constant->index, 1.0}});
  std::vector<IndexShare> lines;
  for (const SpectralSample& line : spectrum.lines())
    lines.push_back(
        {refractiveIndex(scene.ice, line.wavelength), line.light / static_cast<double>(spectrum.lines().size())});
  return IceLight(lines);
}

/// Lengths of a population's prisms, each with its share of the surface.
std::vector<PrismShare> prismsOf(const PopulationSettings& settings) {
  const Population population(settings);
  const AngleQuantile* stretch = population.stretch();
  if (!stretch) return {{2.0 * std::get<FixedValue>(std::get<PrismSettings>(settings.shape).aspect).value, 1.0}};
  std::vector<PrismShare> prisms;
  for (int k = 0; k < kAspects; ++k) prisms.push_back({2.0 * stretch->at((k + 0.5) / kAspects), 1.0 / kAspects});
  return prisms;
}

/// From which the mean crystal follows.
struct CrystalSums {
  double crystals = 0.0, volume = 0.0, surface = 0.0, shadow = 0.0;
};

/// Sums of all populations, each by its share of the light.
class Sum {
 public:
  explicit Sum(const IntegralProfileSettings& settings)
      : settings_(settings),
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
    s.byOrderRest = 1.0 - s.external - s.cutOff;
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
  std::vector<double> light_, squares_;
  ScatterTotals totals_;
  double gSquares_ = 0.0, pathSquares_ = 0.0;
  CrystalSums mean_;
  IntegratedProfile result_;
};

}  // namespace

std::string objectionToIntegral(const Scene& scene) {
  if (scene.trace.paths.filter) return "light is filtered by its raypaths";
  for (const PopulationSettings& population : scene.populations) {
    const std::string name = "population " + population.name;
    if (!std::holds_alternative<PrismSettings>(population.shape)) return name + " has crystals that are no prisms";
    if (!std::holds_alternative<RandomOrientation>(population.orientation))
      return name + " is not randomly oriented, and has another profile for each place of the sun";
  }
  return {};
}

IntegratedProfile integrateProfile(const Scene& scene, const IntegralProfileSettings& settings) {
  if (const std::string objection = objectionToIntegral(scene); !objection.empty())
    throw std::invalid_argument(objection);
  double all = 0.0;
  for (const PopulationSettings& population : scene.populations) all += population.weight;
  Sum sum(settings);
  for (const PopulationSettings& population : scene.populations) {
    if (population.weight == 0.0) continue;
    // Randomly oriented convex crystals intercept light as they have surface (Cauchy).
    const ScatterScene prisms{PrismSection(), prismsOf(population), iceLightOf(scene)};
    ScatterAccuracy accuracy;
    accuracy.error = settings.error;
    accuracy.detailed = settings.detailed;
    sum.add(prisms, integrateScatter(prisms, accuracy, settings.bins, settings.from, settings.to),
            population.weight / all);
  }
  return sum.result();
}

}  // namespace parhelion
