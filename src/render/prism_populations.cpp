// SPDX-License-Identifier: Apache-2.0
#include "render/prism_populations.h"

#include <algorithm>
#include <cmath>

#include "crystal/population.h"
#include "math/gauss_legendre.h"
#include "optics/ice.h"
#include "optics/spectrum.h"
#include "render/air_background.h"

namespace parhelion {

namespace {

// Nodes at which the spectrum's light is added up, and at which its indices are kept.
constexpr int kSpectrumNodes = 4096, kIndexNodes = 256;
// Continuous light is looked up in so many steps.
constexpr int kColourSteps = 1024;
// Crystals of spread aspect ratios are as many as bring their own error well below that of the picture: measured of
// columns from 0.4 to 2.5, 3 of them err by 1 %, 4 by 0.6, 5 by 0.4, 6 by 0.2, 8 by 0.1.
struct AspectsFor {
  double error;  // of the picture, at least
  int count;
};
constexpr AspectsFor kAspects[] = {{0.04, 3}, {0.015, 4}, {0.01, 5}, {0.005, 6}, {0.0, 8}};

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

/// The indices of an ice that has them whatever the wavelength; empty for others.
std::vector<double> fixedIndices(const IceSettings& ice) {
  if (const auto* mixture = std::get_if<IndexMixture>(&ice.index)) return mixture->indices;
  if (const auto* constant = std::get_if<ConstantIndex>(&ice.index)) return {constant->index};
  return {};
}

Tristimulus colourOf(const SpectralSample& sample, Counted counted) {
  if (counted == Counted::energy) return {sample.light, sample.light, sample.light};
  return {sample.xyz.x, sample.xyz.y, sample.xyz.z};
}

/// All of a spectrum's light as lines: each meets each of the ice's indices. Empty for continuous light in ice whose
/// index depends on the wavelength.
std::vector<IndexColour> linesOf(const Scene& scene, Counted counted) {
  const Spectrum spectrum(sunAtCloud(scene).spectrum);
  const std::vector<double> fixed = fixedIndices(scene.ice);
  std::vector<IndexColour> lines;
  if (fixed.empty())
    for (const SpectralSample& line : spectrum.lines())
      lines.push_back({refractiveIndex(scene.ice, line.wavelength), colourOf(line, counted)});
  // What meets the same index goes the same ways, whatever its colour.
  const Vec3 white = counted == Counted::energy ? Vec3(1.0) : spectrum.white();
  for (const double index : fixed) lines.push_back({index, {white.x, white.y, white.z}});
  return lines;
}

}  // namespace

IceLight iceLightOf(const Scene& scene) {
  const Spectrum spectrum(sunAtCloud(scene).spectrum);
  if (spectrum.lines().empty() && !isWithoutDispersion(scene.ice))
    return IceLight::continuous(indicesAtShares(spectrum, scene.ice));
  std::vector<IndexShare> lines;
  const std::vector<double> fixed = fixedIndices(scene.ice);
  for (const double index : fixed) lines.push_back({index, 1.0 / static_cast<double>(fixed.size())});
  if (!fixed.empty()) return IceLight(lines);
  for (const SpectralSample& line : spectrum.lines())
    lines.push_back(
        {refractiveIndex(scene.ice, line.wavelength), line.light / static_cast<double>(spectrum.lines().size())});
  return IceLight(lines);
}

std::vector<PrismShare> prismsOf(const PopulationSettings& settings, int count) {
  const Population population(settings);
  const AngleQuantile* stretch = population.stretch();
  if (!stretch) return {{2.0 * std::get<FixedValue>(std::get<PrismSettings>(settings.shape).aspect).value, 1.0}};
  std::vector<PrismShare> prisms;
  for (const QuadratureNode& node : gaussLegendre(count))
    prisms.push_back({2.0 * stretch->at(0.5 + 0.5 * node.x), 0.5 * node.weight});
  return prisms;
}

int aspectsFor(double error) {
  return std::ranges::find_if(kAspects, [&](const AspectsFor& a) { return error >= a.error; })->count;
}

IndexSampler::IndexSampler(const Scene& scene, Counted counted) : lines_(linesOf(scene, counted)) {
  if (!lines_.empty()) return;
  const Spectrum spectrum(sunAtCloud(scene).spectrum);
  for (int k = 0; k < kColourSteps; ++k) {
    const SpectralSample sample = spectrum.sample((k + 0.5) / kColourSteps);
    continuous_.push_back({refractiveIndex(scene.ice, sample.wavelength), colourOf(sample, counted)});
  }
}

IndexColour IndexSampler::at(double u) const {
  const auto nth = [u](const std::vector<IndexColour>& all) {
    return std::min(static_cast<std::size_t>(u * static_cast<double>(all.size())), all.size() - 1);
  };
  if (!lines_.empty()) return lines_[nth(lines_)];
  return continuous_[nth(continuous_)];
}

std::vector<double> IndexSampler::nodes() const {
  std::vector<double> all;
  for (const auto* light : {&lines_, &continuous_})
    for (const IndexColour& one : *light) all.push_back(one.index);
  std::ranges::sort(all);
  all.erase(std::ranges::unique(all).begin(), all.end());
  if (all.size() <= IceLight::kMixed) return all;
  return {all.front(), 0.5 * (all.front() + all.back()), all.back()};
}

std::string objectionTo(const Scene& scene, const PopulationSettings& population, bool inProfile) {
  constexpr double kSixth = kPi / 3.0, kTurn = 2.0 * kPi;
  const auto* prism = std::get_if<PrismSettings>(&population.shape);
  if (!prism) return "has crystals that are no prisms";
  if (!prism->isPlain()) return "has crystals with pits, caps or notches";
  if (!isHexagonal(*prism)) return "has crystals that are no regular prisms";
  if (scene.ice.absorbs) return "absorbs light";
  if (population.distortion > 0.0) return "has faces that are tilted by chance";
  if (population.diffracts) return "spreads light by diffraction";
  if (std::holds_alternative<RandomOrientation>(population.orientation)) return {};
  if (inProfile) return "is not randomly oriented, and has another profile for each place of the sun";
  if (standingOf(population.orientation)) return {};
  const auto* axis = std::get_if<AxisOrientation>(&population.orientation);
  if (!axis) return "turns about an axis across c, by more than one angle";
  if (!isFree(axis->azimuth, kTurn)) return "does not face all azimuths alike";
  if (!isFree(axis->roll, kSixth)) return "has neither all rolls alike nor one tilt and one roll";
  return {};
}

}  // namespace parhelion
