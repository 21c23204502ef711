// SPDX-License-Identifier: Apache-2.0
#include "recon/published/gonzato_marchand.h"

#include <cmath>
#include <cstdio>

#include "math/portable.h"
#include "parallel/loops.h"
#include "recon/methods.h"
#include "recon/published/sinc_filter.h"

namespace parhelion {
namespace {

constexpr double kPaperSamples = 16.0;  // m of paper gain
constexpr double kStart = 0.3;          // share of the work before the first iteration
constexpr double kRounding = 1e-9;      // relative, of a residual that no longer falls

using Lights = std::vector<Raster<double>>;

/// The sum of f(value) over a picture.
template <class F>
double sumOf(const Raster<double>& grid, const F& f) {
  return sumOverRows(grid.height(), [&](int y) {
    double sum = 0.0;
    for (int x = 0; x < grid.width(); ++x) sum += f(grid.at(x, y));
    return sum;
  });
}

double rms(const Raster<double>& grid) {
  const double squares = sumOf(grid, [](double value) { return value * value; });
  return std::sqrt(squares / static_cast<double>(grid.size()));
}

/// The m for a map of so many hits. Pixels that hold m hits by themselves count as m: they need no squares, and one hot
/// pixel must not blur all others.
double defaultSamples(const Raster<double>& hits) {
  double samples = hitsPerSquare(sumOf(hits, [](double h) { return h; }));
  for (int round = 0; round < 4; ++round) {
    samples = hitsPerSquare(sumOf(hits, [&](double h) { return std::min(h, samples); }));
  }
  return samples;
}

/// What the filter is given: light, or in the paper's reading light per solid angle where there is any.
Lights known(const HitMap& map, KernelGain gain) {
  if (gain == KernelGain::unit) return map.lights;
  Lights values = map.lights;
  for (Raster<double>& light : values) {
    for (std::size_t i = 0; i < light.size(); ++i) light[i] = map.hits()[i] > 0.0 ? light[i] / map.omega[i] : 0.0;
  }
  return values;
}

/// What the picture lacks of what is known; in the paper's reading, where something is known.
Lights lacking(const HitMap& map, KernelGain gain, const Lights& wanted, const Lights& picture) {
  Lights rest = wanted;
  for (std::size_t kind = 0; kind < rest.size(); ++kind) {
    for (std::size_t i = 0; i < rest[kind].size(); ++i) {
      if (gain == KernelGain::unit)
        rest[kind][i] -= picture[kind][i] * map.omega[i];
      else if (map.hits()[i] > 0.0)
        rest[kind][i] -= picture[kind][i];
    }
  }
  return rest;
}

template <class... Args>
std::string formatted(const char* format, Args... args) {
  char text[200];
  std::snprintf(text, sizeof text, format, args...);
  return text;
}

/// Adds what the filter makes of the rest, as long as the rest becomes less.
void iterate(const HitMap& map, const GonzatoMarchandSettings& settings, const SincFilter& filter, const Lights& wanted,
             const Watch& watch, Reconstruction& result) {
  if (settings.iterations == 0) return;
  Lights rest = lacking(map, settings.gain, wanted, result.lights);
  double error = rms(rest.front());
  for (int i = 1; i <= settings.iterations; ++i) {
    watch.at(kStart + (1.0 - kStart) * i / (settings.iterations + 1));
    Lights next = filter(rest);
    for (std::size_t kind = 0; kind < next.size(); ++kind) {
      for (std::size_t p = 0; p < next[kind].size(); ++p) next[kind][p] += result.lights[kind][p];
    }
    rest = lacking(map, settings.gain, wanted, next);
    const double nextError = rms(rest.front());
    if (!(nextError <= error * (1.0 + kRounding))) {
      result.remarks.push_back(
          formatted("iteration %d raises the residual from %.4g to %.4g (rms, hits per pixel): "
                    "stopped after %d",
                    i, error, nextError, i - 1));
      return;
    }
    result.lights = std::move(next);
    error = nextError;
  }
}

}  // namespace

double hitsPerSquare(double hits) { return std::max(0.28 * portable::exp(0.57 * portable::log(hits)), 16.0); }

Reconstruction reconstructHits(const HitMap& map, const GonzatoMarchandSettings& settings, const Watch& watch) {
  watch.at(0.0);
  Reconstruction result;
  if (!(sumOf(map.hits(), [](double h) { return h; }) > 0.0)) {
    result.lights.assign(map.lights.size(), Raster<double>(map.width(), map.height()));
    return result;
  }
  double samples = kPaperSamples;
  if (settings.samples)
    samples = *settings.samples;
  else if (settings.gain == KernelGain::unit)
    samples = defaultSamples(map.hits()) * settings.lobes * settings.lobes;
  if (!settings.samples) result.remarks.push_back(formatted("squares grow until they hold %.0f hits", samples));

  const SincFilter filter(map, settings, samples, watch);
  watch.at(kStart);
  const Lights wanted = known(map, settings.gain);
  result.lights = filter(wanted);
  iterate(map, settings, filter, wanted, watch, result);
  return result;
}

}  // namespace parhelion
