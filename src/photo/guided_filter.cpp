// SPDX-License-Identifier: Apache-2.0
#include "photo/guided_filter.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace parhelion {

namespace {

// Means over windows, cut off at the borders, by running sums over columns and then along the row.
template <std::size_t N>
Raster<std::array<float, N>> windowMeans(const Raster<std::array<float, N>>& values, int radius) {
  using Sum = std::array<double, N>;
  const int width = values.width(), height = values.height();
  Raster<std::array<float, N>> means(width, height);
  std::vector<Sum> columns(static_cast<std::size_t>(width));
  const auto addRow = [&](int y, double sign) {
    if (y < 0 || y >= height) return;
    for (int x = 0; x < width; ++x) {
      for (std::size_t k = 0; k < N; ++k)
        columns[static_cast<std::size_t>(x)][k] += sign * static_cast<double>(values.at(x, y)[k]);
    }
  };
  for (int y = 0; y < radius; ++y) addRow(y, 1.0);
  for (int y = 0; y < height; ++y) {
    addRow(y + radius, 1.0);
    addRow(y - radius - 1, -1.0);
    const int rows = std::min(y + radius, height - 1) - std::max(y - radius, 0) + 1;
    Sum sum{};
    const auto addColumn = [&](int x, double sign) {
      if (x < 0 || x >= width) return;
      for (std::size_t k = 0; k < N; ++k) sum[k] += sign * columns[static_cast<std::size_t>(x)][k];
    };
    for (int x = 0; x < radius; ++x) addColumn(x, 1.0);
    for (int x = 0; x < width; ++x) {
      addColumn(x + radius, 1.0);
      addColumn(x - radius - 1, -1.0);
      const int count = rows * (std::min(x + radius, width - 1) - std::max(x - radius, 0) + 1);
      for (std::size_t k = 0; k < N; ++k) means.at(x, y)[k] = static_cast<float>(sum[k] / count);
    }
  }
  return means;
}

// Guide (3), input, guide x input (3), products of guide components (rr, rg, rb, gg, gb, bb).
using Moments = std::array<float, 13>;

Moments momentsOf(const GuideColour& g, float p) {
  return {g[0],        g[1],        g[2],        p,           g[0] * p,    g[1] * p,   g[2] * p,
          g[0] * g[0], g[0] * g[1], g[0] * g[2], g[1] * g[1], g[1] * g[2], g[2] * g[2]};
}

// Slopes (covariance + epsilon)^-1 cov(guide, input) by cofactors, and the offset.
std::array<float, 4> lineOf(const Moments& m, float epsilon) {
  const auto d = [&](std::size_t i) { return static_cast<double>(m[i]); };
  const double r = d(0), g = d(1), b = d(2), p = d(3), e = static_cast<double>(epsilon);
  const double rp = d(4) - r * p, gp = d(5) - g * p, bp = d(6) - b * p;
  const double rr = d(7) - r * r + e, rg = d(8) - r * g, rb = d(9) - r * b;
  const double gg = d(10) - g * g + e, gb = d(11) - g * b, bb = d(12) - b * b + e;
  const double crr = gg * bb - gb * gb, crg = gb * rb - rg * bb, crb = rg * gb - gg * rb;
  const double cgg = rr * bb - rb * rb, cgb = rb * rg - rr * gb, cbb = rr * gg - rg * rg;
  const double determinant = rr * crr + rg * crg + rb * crb;
  const double ar = (crr * rp + crg * gp + crb * bp) / determinant;
  const double ag = (crg * rp + cgg * gp + cgb * bp) / determinant;
  const double ab = (crb * rp + cgb * gp + cbb * bp) / determinant;
  return {static_cast<float>(ar), static_cast<float>(ag), static_cast<float>(ab),
          static_cast<float>(p - ar * r - ag * g - ab * b)};
}

}  // namespace

GuidedFilter::GuidedFilter(const Raster<GuideColour>& guide, const Raster<float>& input, int radius, float epsilon) {
  if (guide.width() != input.width() || guide.height() != input.height() || input.size() == 0) {
    throw std::invalid_argument("a guided filter needs a guide of its input's size");
  }
  Raster<Moments> moments(guide.width(), guide.height());
  for (std::size_t i = 0; i < guide.size(); ++i) moments[i] = momentsOf(guide[i], input[i]);
  moments = windowMeans(moments, radius);
  Raster<std::array<float, 4>> lines(guide.width(), guide.height());
  for (std::size_t i = 0; i < guide.size(); ++i) lines[i] = lineOf(moments[i], epsilon);
  line_ = windowMeans(lines, radius);
}

float GuidedFilter::at(float x, float y, const GuideColour& colour) const {
  const float u = std::clamp(x - 0.5F, 0.0F, static_cast<float>(line_.width() - 1));
  const float v = std::clamp(y - 0.5F, 0.0F, static_cast<float>(line_.height() - 1));
  const int x0 = static_cast<int>(u), y0 = static_cast<int>(v);
  const float s = u - static_cast<float>(x0), t = v - static_cast<float>(y0);
  const auto &a = line_.nearest(x0, y0), &b = line_.nearest(x0 + 1, y0);
  const auto &c = line_.nearest(x0, y0 + 1), &d = line_.nearest(x0 + 1, y0 + 1);
  float result = 0.0F;
  for (std::size_t k = 0; k < 4; ++k) {
    const float top = a[k] + (b[k] - a[k]) * s, bottom = c[k] + (d[k] - c[k]) * s;
    result += (top + (bottom - top) * t) * (k < 3 ? colour[k] : 1.0F);
  }
  return result;
}

}  // namespace parhelion
