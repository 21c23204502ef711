// SPDX-License-Identifier: Apache-2.0
#include "recon/published/sinc_filter.h"

#include <algorithm>

#include "parallel/loops.h"
#include "recon/published/sky_balance.h"

namespace parhelion {

SincFilter::SincFilter(const HitMap& map, const GonzatoMarchandSettings& settings, double samples, const Watch& watch)
    : settings_(settings),
      sky_(map),
      radii_(squareSizes(map, sky_, samples)),
      bank_(radii_, sky_.shape, settings.lobes, settings.gain) {
  watch.at(0.1);
  if (settings.gain == KernelGain::paper) return;
  factors_ = borderFactors(sky_, radii_, bank_, settings.lobes, settings.flow);
  if (settings.flow == KernelFlow::gather) return;
  countedSky_ = sky_.share;
  for (std::size_t i = 0; i < countedSky_.size(); ++i) countedSky_[i] *= factors_[i];
  toBalance_ = reachesBeyond(countedSky_, sky_, radii_, bank_);
}

std::vector<Raster<double>> SincFilter::operator()(const std::vector<Raster<double>>& lights) const {
  const std::vector<LitRow> sources = litRows(lights);
  const int width = sky_.shape.width, height = sky_.shape.height;
  std::vector<Raster<double>> out(lights.size(), Raster<double>(width, height));
  if (settings_.flow == KernelFlow::scatter) {
    constexpr int kBand = 16;  // rows; every band adds up all its sources in the same order
    forEach((height + kBand - 1) / kBand,
            [&](int band) { scatterRows(sources, band * kBand, std::min((band + 1) * kBand, height), out); });
  } else {
    std::vector<int> litAt;  // rows with any light
    for (int y = 0; y < height; ++y) {
      if (!sources[static_cast<std::size_t>(y)].columns.empty()) litAt.push_back(y);
    }
    forRows(height, [&](int y) { gatherRow(sources, litAt, lights, y, out); });
  }
  forRows(height, [&](int y) {
    for (int x = 0; x < width; ++x) {
      const double gain = outputGain(x, y);
      for (Raster<double>& light : out) light.at(x, y) *= gain;
    }
  });
  return out;
}

double SincFilter::outputGain(int x, int y) const {
  if (sky_.share.at(x, y) <= 0.0F) return 0.0;
  return settings_.gain == KernelGain::paper ? 1.0 : static_cast<double>(factors_.at(x, y)) / sky_.whole.at(x, y);
}

std::vector<SincFilter::LitRow> SincFilter::litRows(const std::vector<Raster<double>>& lights) const {
  const bool balanced = settings_.flow == KernelFlow::scatter && settings_.gain == KernelGain::unit;
  std::vector<LitRow> rows(static_cast<std::size_t>(sky_.shape.height));
  forRows(sky_.shape.height, [&](int y) {
    LitRow& row = rows[static_cast<std::size_t>(y)];
    for (int x = 0; x < sky_.shape.width; ++x) {
      if (sky_.share.at(x, y) <= 0.0F) continue;
      if (std::ranges::all_of(lights, [&](const Raster<double>& light) { return light.at(x, y) == 0.0; })) continue;
      row.columns.push_back(x);
      for (const Raster<double>& light : lights) row.amounts.push_back(light.at(x, y));
      row.reach = std::max(row.reach, bank_.at(radii_.at(x, y)).reachY());
    }
    if (balanced) balanceSources(row, y, lights.size());
  });
  return rows;
}

/// Makes the light that arrives in the sky equal to the light that leaves.
void SincFilter::balanceSources(LitRow& row, int y, std::size_t kinds) const {
  for (std::size_t i = 0; i < row.columns.size(); ++i) {
    const int x = row.columns[i];
    if (toBalance_.at(x, y) == 0) continue;
    const double arrives = sumUnder(bank_.at(radii_.at(x, y)), countedSky_, x, y, sky_.shape);
    for (std::size_t kind = 0; kind < kinds; ++kind) row.amounts[i * kinds + kind] /= arrives;
  }
}

void SincFilter::scatterRows(const std::vector<LitRow>& sources, int first, int last,
                             std::vector<Raster<double>>& out) const {
  const PictureShape& shape = sky_.shape;
  const std::size_t kinds = out.size();
  // Adds one row of a kernel around (x, y).
  const auto add = [&](const SincKernel::Row& row, int x, int y, const double* amounts) {
    forColumns(x, row.reach, shape.width, shape.wrapX, [&](int from, int count, int dx) {
      const float* weights = row.weights + dx;
      for (std::size_t kind = 0; kind < kinds; ++kind) {
        double* pixels = out[kind].row(y) + from;
        for (int i = 0; i < count; ++i) pixels[i] += static_cast<double>(weights[i]) * amounts[kind];
      }
    });
  };
  for (int y = 0; y < shape.height; ++y) {
    const LitRow& lit = sources[static_cast<std::size_t>(y)];
    forColumns(y, lit.reach, shape.height, shape.wrapY, [&](int top, int rows, int offset) {
      const int middle = top - offset, from = std::max(top, first), to = std::min(top + rows, last);
      if (from >= to) return;
      for (std::size_t i = 0; i < lit.columns.size(); ++i) {
        const SincKernel& kernel = bank_.at(radii_.at(lit.columns[i], y));
        const int above = std::max(from, middle - kernel.reachY()), below = std::min(to, middle + kernel.reachY() + 1);
        for (int target = above; target < below; ++target) {
          add(kernel.row(target - middle), lit.columns[i], target, lit.amounts.data() + i * kinds);
        }
      }
    });
  }
}

void SincFilter::gatherRow(const std::vector<LitRow>& sources, const std::vector<int>& litAt,
                           const std::vector<Raster<double>>& lights, int y, std::vector<Raster<double>>& out) const {
  const PictureShape& shape = sky_.shape;
  const std::size_t kinds = out.size();
  // What (x, y) gets from columns `from` to `from + count` of a row through `weights`.
  const auto take = [&](const float* weights, int row, int from, int count, int x) {
    const LitRow& lit = sources[static_cast<std::size_t>(row)];
    const auto begin = std::ranges::lower_bound(lit.columns, from);
    const auto end = std::lower_bound(begin, lit.columns.end(), from + count);
    if (4 * (end - begin) > count) {  // pixel by pixel is faster than hit by hit
      for (std::size_t kind = 0; kind < kinds; ++kind)
        out[kind].at(x, y) += dot(weights, lights[kind].row(row) + from, count);
      return;
    }
    const double* amounts = lit.amounts.data() + static_cast<std::size_t>(begin - lit.columns.begin()) * kinds;
    for (auto column = begin; column != end; ++column, amounts += kinds) {
      const auto weight = static_cast<double>(weights[*column - from]);
      for (std::size_t kind = 0; kind < kinds; ++kind) out[kind].at(x, y) += weight * amounts[kind];
    }
  };
  for (int x = 0; x < shape.width; ++x) {
    if (sky_.share.at(x, y) <= 0.0F) continue;
    const SincKernel& kernel = bank_.at(radii_.at(x, y));
    forColumns(y, kernel.reachY(), shape.height, shape.wrapY, [&](int top, int rows, int dy) {
      for (auto lit = std::ranges::lower_bound(litAt, top); lit != litAt.end() && *lit < top + rows; ++lit) {
        const SincKernel::Row row = kernel.row(dy + *lit - top);
        forColumns(x, row.reach, shape.width, shape.wrapX,
                   [&](int from, int count, int dx) { take(row.weights + dx, *lit, from, count, x); });
      }
    });
  }
}

}  // namespace parhelion
