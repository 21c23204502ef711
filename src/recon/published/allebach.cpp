// SPDX-License-Identifier: Apache-2.0
#include "recon/published/allebach.h"

#include <cmath>
#include <sstream>

namespace parhelion {

namespace {

constexpr double kMostGrowth = 1.1;  // of the residual in one iteration
constexpr double kRounding = 1e-13;  // residual over values below which growth is rounding, not divergence

double weightedRms(const std::vector<double>& values, const std::vector<double>& weights) {
  double sum = 0.0, total = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    sum += weights[i] * values[i] * values[i];
    total += weights[i];
  }
  return total > 0.0 ? std::sqrt(sum / total) : 0.0;
}

std::vector<std::vector<double>> residuals(const KnownValues& known, const Sample& sample,
                                           const std::vector<Raster<double>>& pictures) {
  std::vector<std::vector<double>> rest = known.lights;
  for (std::size_t k = 0; k < rest.size(); ++k) {
    const std::vector<double> values = sample(pictures[k]);
    for (std::size_t i = 0; i < values.size(); ++i) rest[k][i] -= values[i];
  }
  return rest;
}

void add(std::vector<Raster<double>>& pictures, double factor, const std::vector<Raster<double>>& more) {
  for (std::size_t k = 0; k < pictures.size(); ++k) {
    for (std::size_t i = 0; i < pictures[k].size(); ++i) pictures[k][i] += factor * more[k][i];
  }
}

// One picture of the iteration and what it leaves.
struct Step {
  int iteration = 0;
  double residual = 0.0;
};

std::string growthRemark(const Step& best, const Step& last) {
  std::ostringstream text;
  text.precision(3);
  text << "iteration " << last.iteration << ": the residual grew from " << best.residual << " to " << last.residual
       << "; stopped at " << best.iteration;
  return text.str();
}

}  // namespace

KnownValues hitPixels(const HitMap& map) {
  KnownValues known;
  for (std::size_t i = 0; i < map.omega.size(); ++i) {
    if (!(map.hits()[i] > 0.0)) continue;
    known.pixels.push_back(i);
    known.weights.push_back(map.omega[i]);
  }
  for (const Raster<double>& light : map.lights) {
    std::vector<double>& values = known.lights.emplace_back();
    for (const std::size_t i : known.pixels) values.push_back(light[i] / map.omega[i]);
  }
  return known;
}

KnownValues voronoiCells(const HitMap& map, const NearestHits& nearest, HitReading reading) {
  KnownValues known{nearest.pixels(), nearest.cellSums(map.omega), {}};
  for (const Raster<double>& light : map.lights) {
    std::vector<double>& values = known.lights.emplace_back();
    for (std::size_t i = 0; i < known.pixels.size(); ++i) {
      const std::size_t pixel = known.pixels[i];
      values.push_back(light[pixel] / (reading == HitReading::intensities ? map.omega[pixel] : known.weights[i]));
    }
  }
  return known;
}

Sample valuesAt(const std::vector<std::size_t>& pixels) {
  return [&pixels](const Raster<double>& picture) {
    std::vector<double> values;
    values.reserve(pixels.size());
    for (const std::size_t i : pixels) values.push_back(picture[i]);
    return values;
  };
}

Reconstruction allebach(const KnownValues& known, const Sample& sample, const Spread& spread, int iterations,
                        double relaxation, const Watch& watch) {
  std::vector<Raster<double>> pictures = spread(known.lights);
  for (Raster<double>& picture : pictures) {
    for (std::size_t i = 0; i < picture.size(); ++i) picture[i] *= relaxation;
  }
  if (iterations == 0) return {std::move(pictures), {}};

  std::vector<std::vector<double>> rest = residuals(known, sample, pictures);
  Step best{0, weightedRms(rest[0], known.weights)}, last = best;
  Reconstruction result{pictures, {}};
  for (int i = 1, growing = 0; i <= iterations && growing < 2; ++i) {
    watch.at(static_cast<double>(i) / (iterations + 1));
    add(pictures, relaxation, spread(rest));
    rest = residuals(known, sample, pictures);
    const Step step{i, weightedRms(rest[0], known.weights)};
    growing = step.residual > kMostGrowth * last.residual ? 2 : step.residual > last.residual ? growing + 1 : 0;
    last = step;
    if (step.residual >= best.residual) continue;
    best = step;
    result.lights = pictures;
  }
  const double rounding = kRounding * weightedRms(known.lights[0], known.weights);
  if (last.iteration != best.iteration && last.residual > rounding) result.remarks.push_back(growthRemark(best, last));
  return result;
}

}  // namespace parhelion
